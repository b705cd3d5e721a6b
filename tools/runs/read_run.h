// The first half of a run: from flags to a volume and a level.
#pragma once

#include <iosfwd>

#include "tools/flags/input_flags.h"
#include "tools/runs/run_result.h"

namespace isoloop {

/// One line for each of the volume's warnings.
void print_warnings(std::ostream& out, const Volume& volume);

/// Reads the volume, prints its warnings to standard error, and settles the level; the analysis is
/// still empty. --max-memory, if given, bounds the process from here on. Throws as
/// check_flags_agree, check_flags_fit_file, read_options, read_volume and iso_level do.
RunInput read_run(const VolumeFlags& volume_flags, const LevelFlags& level_flags);

}  // namespace isoloop
