// HANTUN: the cycles that PAIR finds killed, as handle loops and tunnel loops.
#pragma once

#include <span>
#include <vector>

#include "core/engines/pair.h"
#include "core/loops/loops.h"
#include "core/surface/surface.h"

namespace isoloop {

/// Algorithm 2 of Dey, Li, Sun, Cohen-Steiner (SIGGRAPH 2008): a cycle killed inside is a handle
/// loop, one killed outside a tunnel loop. One loop for each pair, handles by (size, piece), then
/// tunnels, as loops_of_side() numbers them. With an open boundary all are of kind `loop`, by
/// (size, piece). The cycle is taken as it is, with all its closed curves. Not certified:
/// certified() needs the classes that only the dual pass gives.
std::vector<Loop> loops_of_pairs(const Surface& surface, std::span<const SurfacePair> pairs);

}  // namespace isoloop
