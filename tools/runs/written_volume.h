// Volumes that commands write: what a format cannot hold is refused or said.
#pragma once

#include <string>

#include "tools/runs/run_result.h"

namespace isoloop {

/// Throws InvalidArgument, opening with `flag` and `name`, unless isoloop writes volumes to files
/// of this name.
void check_written_format(const std::string& flag, const std::string& name);

/// The same, unless a file of this name can hold the voxels as they are: a .raw file states their
/// layout if it states any, NIfTI has room for them along each axis, and OpenVDB's floats are exact
/// for them.
void check_written(const std::string& flag, const std::string& name, const Volume& volume);

/// Throws LimitExceeded, in stage `stage`, where the writer of such files takes more than
/// run.cost.max_bytes.
void check_writer_memory(const std::string& stage, const std::string& name, const RunInput& run);

/// Warns of what a file of this name does not say of the volume.
void warn_of_left_out(RunInput& run, const std::string& name);

}  // namespace isoloop
