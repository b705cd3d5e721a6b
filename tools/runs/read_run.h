// The first half of a run: from flags to a volume and a level.
#pragma once

#include <string>

#include "core/base/errors.h"
#include "tools/flags/input_flags.h"
#include "tools/runs/run_result.h"
#include "tools/runs/staged_input.h"

namespace isoloop {

/// Reads what the flags name, or its copy if `staged` is one, and prints nothing. Throws as
/// read_volume() does, of the copy in the name of the flags' file.
Volume read_named(const VolumeFlags& flags, const ReadOptions& options, const StagedFile& staged);

/// The volume that the flags ask for. Throws as check_flags_fit_file, read_options and read_volume
/// do.
Volume read_flagged(const VolumeFlags& flags, VdbMargin margin);

/// Takes the range, the level and the hint from the voxels. `is_mask_of_labels`: they were made
/// from labels, which is no reason for a hint. Throws as iso_level does and, with --iso auto, as
/// choose_iso().
void settle_level(RunInput& run, const LevelFlags& flags, bool is_mask_of_labels);

/// Reads the volume, from a pipe too, and nothing of a level; tells no warnings. --max-memory, if
/// given, bounds the process from here on. Throws as check_flags_fit_file, read_options and
/// read_volume do.
RunInput read_input(const VolumeFlags& flags, VdbMargin margin = VdbMargin::background);

/// Reads the volume as read_input() does, settles the level, with --iso auto as choose_iso() does,
/// and tells the warnings on standard error; the analysis is still empty. Throws as
/// check_flags_agree, read_input and iso_level do.
RunInput read_run(const VolumeFlags& volume_flags, const LevelFlags& level_flags);

/// The error, with the advice to read a part made one to take larger voxels if `file` is a mesh, of
/// which no part can be read.
LimitExceeded advised_for(const std::string& file, const LimitExceeded& error);

/// Returns work(), which is about `file`. Throws what it throws, advised_for() the file.
template <class Work>
auto about_file(const std::string& file, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const LimitExceeded& error) {
    throw advised_for(file, error);
  }
}

}  // namespace isoloop
