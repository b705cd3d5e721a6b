// MetaImage (itk.org/Wiki/ITK/MetaIO): a text header, then voxels, or a file of them.
#pragma once

#include <filesystem>
#include <iosfwd>

#include "volume/base/memory_limit.h"
#include "volume/voxels/placement.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// Reads a .mha file, or a .mhd file and the data file that it names; plain or compressed (zlib or
/// gzip) binary voxels. A fourth dimension counts frames. The frame is `lps`, as in ITK, whatever
/// AnatomicalOrientation says.
/// Throws InvalidArgument (several frames, and options.frame does not choose), LimitExceeded, and
/// InvalidInput: bytes that are missing, damaged or too many, a header that makes no sense, several
/// channels, voxels as text, data in several files, a placement that place() refuses.
Volume read_meta_image(const std::filesystem::path& path, const FormatOptions& options = {},
                       const VoxelLimits& limits = {});

/// Writes a .mha file: header and voxels, little-endian, in their stored type. RAS is turned to
/// LPS, which readers take all such files to be in. A failure shows in the stream's state.
void write_meta_image(std::ostream& out, const Volume& volume);

}  // namespace isoloop
