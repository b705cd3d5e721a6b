// Files that hold one slice each: TIFF, PNG and BMP.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

#include "volume/base/file_kind.h"
#include "volume/base/memory_limit.h"
#include "volume/slices/slice_image.h"
#include "volume/voxels/placement.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// FileKind::tiff, png or bmp, by the extension; nothing for other files and for hidden ones.
std::optional<FileKind> slice_kind(const std::filesystem::path& path);

/// Size and type of the slice. Throws InvalidInput as the format's reader does.
SliceImage slice_image(const std::filesystem::path& path);

/// Decodes the slice into `to`, which has its size. Throws as the format's reader does.
void read_slice(const std::filesystem::path& path, const VoxelLimits& limits,
                std::span<std::byte> to);

/// A single .png or .bmp file as a volume of one slice; the frame is `index`, the spacing 1 unless
/// options.spacing says otherwise. Throws LimitExceeded and as read_slice() does.
Volume read_slice_volume(const std::filesystem::path& path, const FormatOptions& options = {},
                         const VoxelLimits& limits = {});

}  // namespace isoloop
