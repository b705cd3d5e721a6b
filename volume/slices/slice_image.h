// What the slices of one volume share, and room for their voxels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "volume/voxels/stored_voxels.h"
#include "volume/voxels/volume.h"

namespace isoloop {

struct SliceImage {
  std::int64_t width = 0;               // pixels
  std::int64_t height = 0;              // pixels
  StoredType type = StoredType::uint8;  // no integers of 64 bits
  bool white_is_zero = false;           // the picture is a negative; its numbers are read as stored

  friend bool operator==(const SliceImage&, const SliceImage&) = default;
};

/// "24 x 20 uint8".
std::string slice_text(const SliceImage& image);

/// Bytes of one slice. Throws InvalidInput if it has no size, and as checked_voxel_bytes does.
std::uint64_t slice_bytes(const SliceImage& image, const std::string& what);

/// So many voxels, all 0.
VoxelArray zero_voxels(StoredType type, std::size_t count);

}  // namespace isoloop
