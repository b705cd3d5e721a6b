// Betti numbers of the solid I, or of M where it is not closed, read off M.
#pragma once

#include <cstdint>

#include "core/surface/surface.h"

namespace isoloop {

/// Of I: its components, its independent tunnels (as many as the genus of M), and its cavities,
/// the components of O that do not reach the border. With an open boundary of M: its components,
/// its independent loops, and its components without a border.
struct Betti {
  std::int64_t b0 = 0;
  std::int64_t b1 = 0;
  std::int64_t b2 = 0;

  bool operator==(const Betti&) const = default;
};

/// Of I by Alexander duality in the 3-sphere: every component of M is the outer border of one
/// component of I or the border of one cavity, and b1(I) is the sum of their genera.
Betti betti_numbers(const Surface& surface);

}  // namespace isoloop
