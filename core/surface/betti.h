// Betti numbers of the solid I, or of M where it is not closed, read off M.
#pragma once

#include "core/surface/surface.h"
#include "isoloop/surface.h"

namespace isoloop {

/// Of I by Alexander duality in the 3-sphere: every component of M is the outer border of one
/// component of I or the border of one cavity, and b1(I) is the sum of their genera.
Betti betti_numbers(const Surface& surface);

}  // namespace isoloop
