// VTK's XML image data (VTK User's Guide, file formats).
#pragma once

#include <filesystem>
#include <iosfwd>

#include "volume/base/memory_limit.h"
#include "volume/voxels/placement.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// Reads an array of a .vti file of one piece, options.array: see choose_array(); as text, in
/// base64 or raw, plain or compressed with zlib. Of point data each point is a voxel; of cell data
/// each cell is one, whose centre lies half a spacing in. The frame is `world`. Throws
/// InvalidArgument (several arrays, and none is chosen), LimitExceeded (the file itself is held in
/// memory too), and InvalidInput: bytes that are missing, damaged or too many, a header that makes
/// no sense, several components, other compressors, several pieces, a placement that place()
/// refuses.
Volume read_vti(const std::filesystem::path& path, const FormatOptions& options = {},
                const VoxelLimits& limits = {});

/// Writes point data, raw and little-endian, appended: `distance` of a level set, `mask`, else
/// `values`. The format has no name for LPS and RAS. A failure shows in the stream's state.
void write_vti(std::ostream& out, const Volume& volume);

}  // namespace isoloop
