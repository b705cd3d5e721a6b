// Volumes to files.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "isoloop/volume.h"

namespace isoloop {

/// What write_volume() writes to a file, to a stream: in the format that `path` is named for. A
/// failure to write shows in the stream's state.
void write_volume(std::ostream& out, const Volume& volume, const std::filesystem::path& path);

/// What a file of this name cannot say of the volume's place and unit, a sentence each.
std::vector<Finding> left_out_of(const Volume& volume, const std::filesystem::path& path);

}  // namespace isoloop
