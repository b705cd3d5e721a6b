#include "tools/runs/repair_run.h"

#include <utility>

#include "core/base/stage.h"
#include "tools/runs/read_run.h"

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

}  // namespace isoloop
