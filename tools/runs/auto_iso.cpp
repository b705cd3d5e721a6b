#include "tools/runs/auto_iso.h"

#include "core/base/errors.h"
#include "core/base/stage.h"
#include "tools/runs/scan_run.h"
#include "tools/words/number_text.h"
#include "tools/words/value_hints.h"

namespace isoloop {

ChosenIso choose_iso(const RunInput& run, const Progress& progress) {
  const std::string by = "chosen by --iso auto: ";
  if (run.volume.level_set) return {0.0, by + "the surface of a level set"};
  if (is_mask(run.range))
    return {(run.range.min + run.range.max) / 2, by + "the middle of a mask's two values"};
  const std::string labels = labels_text(run);
  if (!labels.empty()) throw InvalidArgument("--iso auto finds no iso value: " + labels);
  const Scan scan = in_stage(
      "scan", [&] { return scan_of(run, scan_values({}, voxels_of(run), run.range), progress); });
  if (!scan.proposed)
    throw InvalidArgument("--iso auto finds no iso value: all voxels are " +
                          shortest_text(run.range.min));
  return {scan.rows[*scan.proposed].iso, by + proposal_text(scan)};
}

}  // namespace isoloop
