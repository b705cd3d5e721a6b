// The first half of a run: from flags to a volume and a level.
#pragma once

#include "tools/input_flags.h"
#include "tools/run_result.h"

namespace isoloop {

/// Reads the volume and settles the level; the analysis is still empty. --max-memory, if given,
/// bounds the process from here on. Throws as read_options, read_volume and iso_level do.
RunResult read_run(const VolumeFlags& volume_flags, const LevelFlags& level_flags);

}  // namespace isoloop
