// What `bench` measured, as a picture.
#pragma once

#include <ostream>

#include "tools/bench/bench_run.h"

namespace isoloop {

/// An SVG of its own, light or dark as the reader's screen: CPU seconds over voxels, both
/// logarithmic, a line for each volume on the least number of threads, and a dashed line of cost
/// that grows as the voxels do.
void write_bench_svg(std::ostream& out, const BenchRun& run);

}  // namespace isoloop
