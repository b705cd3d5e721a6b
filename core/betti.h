// Betti numbers of the solid I, read off its surface.
#pragma once

#include <cstdint>

#include "core/surface.h"

namespace isoloop {

struct Betti {
  std::int64_t b0 = 0;  // components of I
  std::int64_t b1 = 0;  // independent tunnels of I; equals the genus of M
  std::int64_t b2 = 0;  // cavities: components of O that do not reach the border
};

/// Alexander duality in the 3-sphere: every component of M is the outer border of one component
/// of I or the border of one cavity, and b1(I) is the sum of their genera.
Betti betti_numbers(const Surface& surface);

}  // namespace isoloop
