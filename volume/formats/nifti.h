// NIfTI-1 and NIfTI-2 (nifti.nimh.nih.gov): medical volumes, most often of the brain.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>

#include "volume/base/memory_limit.h"
#include "volume/voxels/placement.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// Reads a .nii or .nii.gz file, or a pair .hdr and .img (either may be compressed too, and either
/// may be named), of either byte order. Values are scaled by slope and intercept. The frame is
/// `ras`, by the sform if its code is set, else by the qform; without either it is `index`. The
/// notes say which; a warning says where the two differ by more than a hundredth of a voxel.
/// Throws InvalidArgument (several frames, and options.frame does not choose), LimitExceeded, and
/// InvalidInput: bytes that are missing, damaged or too many, a header that makes no sense, colour,
/// complex and vector voxels, a placement that place() refuses.
Volume read_nifti(const std::filesystem::path& path, const FormatOptions& options = {},
                  const VoxelLimits& limits = {});

/// NIfTI-1 has 16 bits for the voxels along an axis.
inline constexpr std::int64_t most_nifti_voxels = 32767;

/// Whether the format can state this unit: m, mm and µm.
bool nifti_has_unit(const std::string& unit);

/// Writes NIfTI-1, little-endian, by gzip if `packed`: voxels in their stored type; the place as an
/// sform, in RAS (LPS is turned); none of frame `index`, which states lengths alone. The unit goes
/// where it is m, mm or µm. Throws InvalidArgument, naming `what`, if an axis has more than
/// most_nifti_voxels. A failure to write shows in the stream's state.
void write_nifti(std::ostream& out, const Volume& volume, const std::string& what, bool packed);

}  // namespace isoloop
