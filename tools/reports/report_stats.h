// A run as a row of the paper's table 1.
#pragma once

#include <ostream>

#include "tools/runs/run_result.h"

namespace isoloop {

/// Two lines, a head and a row, of the columns of Dey, Li, Sun, Cohen-Steiner (SIGGRAPH 2008),
/// table 1: surface triangles, triangles of K off the surface (pieces of faces cut into fans, both
/// sides), genus, seconds for the geodesic sizes (closest vertices and sizes) and seconds for the
/// loops (all other stages; not the reading).
void write_stats(std::ostream& out, const LoopsRun& run);

}  // namespace isoloop
