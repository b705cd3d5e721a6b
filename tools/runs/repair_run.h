// A run of `repair`, from a volume that was read to changes that are checked.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "tools/runs/run_result.h"

namespace isoloop {

/// Finds the changes and makes none. Throws as repair_loops(), check_counts() and check_loops() do.
RepairRun repaired_run(RunInput volume, Boundary boundary, const RepairRequest& request,
                       const Progress& progress);

/// What a repair changes in the label map that its mask was made of.
struct LabelChanges {
  std::vector<VoxelChange> changes;  // by voxel: labels
  std::int64_t overwritten = 0;      // voxels of other labels than 0 that are inside now
};

/// The changes of a repaired mask of the labels `asked`, as labels_of_sided() has them. Throws
/// SelfCheckFailed if one of them leaves its voxel on its side, which labels cannot say.
LabelChanges changes_of_labels(const Repair& repair, const AnyGridView& labels,
                               const std::vector<std::int64_t>& asked);

}  // namespace isoloop
