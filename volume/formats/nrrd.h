// NRRD (teem.sourceforge.net/nrrd/format.html): a text header, then voxels, or a file of them.
#pragma once

#include <filesystem>
#include <iosfwd>

#include "volume/base/memory_limit.h"
#include "volume/voxels/placement.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// Reads a .nrrd file, or a .nhdr file and the data file that it names; encodings raw and gzip. A
/// fourth axis counts frames. The frame is `lps` or `ras` as `space` says (LAS is turned to `ras`),
/// `world` for other spaces, and `index` without one. The unit is that of `space units` or `units`,
/// where it is one of length, the same for all axes.
/// Throws InvalidArgument (several frames, and options.frame does not choose), LimitExceeded, and
/// InvalidInput: bytes that are missing, damaged or too many, a header that makes no sense, axes of
/// colours, vectors or complex numbers, other encodings, data in several files, a placement that
/// place() refuses.
Volume read_nrrd(const std::filesystem::path& path, const FormatOptions& options = {},
                 const VoxelLimits& limits = {});

/// Writes a header and the voxels, raw and little-endian, in their stored type. The frame and the
/// unit are kept: a volume of frame `index` states spacings and no space. A failure shows in the
/// stream's state.
void write_nrrd(std::ostream& out, const Volume& volume);

}  // namespace isoloop
