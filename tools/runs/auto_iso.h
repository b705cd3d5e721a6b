// The iso value of --iso auto.
#pragma once

#include <string>

#include "core/base/progress.h"
#include "tools/runs/run_result.h"

namespace isoloop {

/// An iso value that the voxels suggest.
struct ChosenIso {
  double iso = 0.0;  // unit of the voxel values
  std::string how;   // "chosen by --iso auto: the middle of the most stable plateau, 52 to 94"
};

/// Of a level set 0, of a mask the middle of its two values, of others what a scan of the run's
/// volume proposes with the rules of its level, whose iso value means nothing. Throws
/// InvalidArgument for label maps and where all voxels have one value, and as scan_of() does.
ChosenIso choose_iso(const RunInput& run, const Progress& progress = {});

}  // namespace isoloop
