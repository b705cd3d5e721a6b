// Volumes to files.
#pragma once

#include <filesystem>
#include <iosfwd>

#include "isoloop/volume.h"

namespace isoloop {

/// What write_volume() writes to a file, to a stream: in the format that `path` is named for. A
/// failure to write shows in the stream's state.
void write_volume(std::ostream& out, const Volume& volume, const std::filesystem::path& path);

}  // namespace isoloop
