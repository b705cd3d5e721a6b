// Tiles of several slices (tag TileDepth), of which libtiff decodes the first slice alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "volume/slices/tiff_file.h"

namespace isoloop {

/// Decodes the tile of this number into `to`, which has the size of its rows of `width` pixels, all
/// slices' rows one after the other. The tile's stored bytes become the one strip of a file in
/// memory that is as wide and has all these rows, which libtiff decodes as it would the tile.
/// Throws InvalidInput where it is damaged.
void read_deep_tile(const TiffFile& file, std::uint32_t number, std::uint32_t width,
                    std::uint32_t rows, std::span<std::byte> to);

}  // namespace isoloop
