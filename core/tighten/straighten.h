// Loops drawn across M's triangles, not along its edges.
#pragma once

#include <vector>

#include "core/loops/certificate.h"
#include "core/loops/loops.h"
#include "core/surface/surface.h"

namespace isoloop {

/// Gives each loop the closed geodesics that its curves shorten to (core/curves/geodesic.h), and
/// their length and centre; no loop gets longer. The class of each geodesic is taken anew, from
/// pushed_to_edges(). M must be closed. Throws SelfCheckFailed where it is not that of its curve.
std::vector<Loop> straightened(const Surface& surface, const SurfaceClasses& classes,
                               std::vector<Loop> loops);

}  // namespace isoloop
