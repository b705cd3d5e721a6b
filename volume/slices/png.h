// PNG files as slices.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "volume/base/memory_limit.h"
#include "volume/slices/slice_image.h"

namespace isoloop {

/// What the header states: uint8, or uint16 for 16 bits a sample. Throws InvalidInput if it is no
/// PNG file.
SliceImage png_image(const std::filesystem::path& path);

/// Decodes the file into `to`, which has the size of png_image(). Grey of 1, 2 and 4 bits is spread
/// over 0 to 255; a palette and colours are read where each of them is grey, and nothing is
/// transparent. Throws InvalidInput: a file that is cut short or whose pixels are damaged, colour,
/// transparency; LimitExceeded.
void read_png(const std::filesystem::path& path, const VoxelLimits& limits,
              std::span<std::byte> to);

}  // namespace isoloop
