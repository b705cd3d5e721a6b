// A run of `repair`, from a volume that was read to changes that are checked.
#pragma once

#include "core/base/progress.h"
#include "tools/runs/run_result.h"

namespace isoloop {

/// Finds the changes and makes none. Throws as repair_loops(), check_counts() and check_loops() do.
RepairRun repaired_run(RunInput volume, Boundary boundary, const RepairRequest& request,
                       const Progress& progress);

}  // namespace isoloop
