#include "tools/runs/repair_run.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/base/errors.h"
#include "core/base/stage.h"
#include "tools/runs/read_run.h"
#include "volume/voxels/labels.h"

namespace isoloop {

RepairRun repaired_run(RunInput volume, Boundary boundary, const RepairRequest& request,
                       const Progress& progress) {
  RepairRun run{std::move(volume)};
  run.repair = about_file(run.file, [&] {
    return in_stage("repair", [&] {
      return repair_loops(
          voxels_of(run), run.level, request,
          {.boundary = boundary, .progress = progress, .max_bytes = run.cost.max_bytes});
    });
  });
  check_counts(run.repair.after);
  check_loops(run.repair.after);
  return run;
}

LabelChanges changes_of_labels(const Repair& repair, const AnyGridView& labels,
                               const std::vector<std::int64_t>& asked) {
  if (repair.shifted_voxels > 0)
    throw SelfCheckFailed("a repair of labels shifts voxels on the side that they are on");
  std::vector<SidedVoxel> sided;
  sided.reserve(repair.changes.size());
  for (const VoxelChange& change : repair.changes)
    sided.push_back({.voxel = change.voxel, .is_inside = change.after > change.before});
  const std::vector<std::int64_t> after = labels_of_sided(labels, sided, asked);
  LabelChanges result;
  result.changes.reserve(sided.size());
  for (std::size_t i = 0; i < sided.size(); ++i) {
    const bool is_asked = std::find(asked.begin(), asked.end(), after[i]) != asked.end();
    if (is_asked != sided[i].is_inside)
      throw SelfCheckFailed("a label is on another side than the repaired mask");
    const double before = std::visit(
        [&](const auto& grid) { return static_cast<double>(grid.values[sided[i].voxel]); }, labels);
    result.changes.push_back({sided[i].voxel, before, static_cast<double>(after[i])});
    if (sided[i].is_inside && before != 0.0) ++result.overwritten;
  }
  return result;
}

}  // namespace isoloop
