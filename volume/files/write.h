// Volumes to files.
#pragma once

#include <filesystem>
#include <iosfwd>

#include "volume/voxels/volume.h"

namespace isoloop {

/// Writes a .raw file (voxels in their stored type, little-endian, first axis fastest; a name such
/// as engine_256x256x128_uint8.raw lets it be read without options), a .nrrd file (see
/// write_nrrd) or a .vdb file (see write_vdb). The file appears whole or not at all.
/// Throws InvalidArgument (another extension) and InvalidInput (it cannot be written).
void write_volume(const Volume& volume, const std::filesystem::path& path);

/// The same to a stream, in the format that `path` is named for. A failure to write shows in the
/// stream's state.
void write_volume(std::ostream& out, const Volume& volume, const std::filesystem::path& path);

}  // namespace isoloop
