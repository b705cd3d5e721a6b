// A finished run made by hand: a torus of nine vertices with one handle loop and one tunnel loop.
#pragma once

#include <sstream>
#include <string>

#include "tools/runs/run_result.h"

namespace isoloop {

/// What report(stream, run) writes.
template <class Report>
std::string written(const Report& report, const LoopsRun& run) {
  std::ostringstream out;
  report(out, run);
  return out.str();
}

/// Vertex 3 i + j lies at angle i round the axis and angle j round the tube. The handle loop runs
/// through vertices 0 1 2, the tunnel loop through 0 3 6. The volume is 10 x 10 x 10 float32 with
/// spacing 0.5 and its origin at (100, 0, 0).
LoopsRun torus_run();

/// The same with features, of which reports tell: the handle's holds vertices 0 to 5, the tunnel's
/// 0, 3, 6 and 7.
LoopsRun torus_run_with_features();

/// The torus cut open by the border of the volume between angles 2 and 0 round the axis: a tube
/// with two border curves. Its one loop is of kind `loop` and runs through vertices 0 1 2.
LoopsRun open_run();

/// The same volume at an iso value that no voxel reaches.
LoopsRun empty_run();

}  // namespace isoloop
