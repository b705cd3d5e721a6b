// Betti numbers of the solid I, or of M where it is not closed, read off M.
#pragma once

#include <cstdint>

#include "core/surface.h"

namespace isoloop {

/// Of I; with an open boundary, where the sides are not told apart, of M.
struct Betti {
  std::int64_t b0 = 0;  // components of I; of M
  std::int64_t b1 = 0;  // independent tunnels of I, the genus of M; independent loops on M
  std::int64_t b2 = 0;  // cavities: components of O that do not reach the border; closed parts of M
};

/// Of I by Alexander duality in the 3-sphere: every component of M is the outer border of one
/// component of I or the border of one cavity, and b1(I) is the sum of their genera.
Betti betti_numbers(const Surface& surface);

}  // namespace isoloop
