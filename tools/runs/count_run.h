// A run of `count`, from a volume that was read to counts that are checked.
#pragma once

#include "core/base/progress.h"
#include "tools/runs/run_result.h"

namespace isoloop {

/// Counts, warns of what a person would frown at, and adds to a mask's hint what the flags that it
/// names would count. Throws as
/// count_topology() and check_counts() do.
CountRun counted_run(RunInput volume, Boundary boundary, const Progress& progress);

}  // namespace isoloop
