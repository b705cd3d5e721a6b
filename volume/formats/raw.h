// Raw volumes: voxels and nothing else, so size and type come from the name or the caller.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>

#include "volume/base/byte_order.h"
#include "volume/base/memory_limit.h"
#include "volume/voxels/crop.h"
#include "volume/voxels/volume.h"

namespace isoloop {

struct RawOptions {
  std::optional<Index3> dims{};     // voxels along each axis; unset: as the file's name states
  std::optional<VoxelType> type{};  // unset: as the file's name states
  Endian endian = Endian::little;
  std::uint64_t skip = 0;         // bytes before the first voxel
  Vec3 spacing{1.0, 1.0, 1.0};    // length per voxel along each axis
  std::optional<CropBox> crop{};  // voxels to read; unset: all
};

struct RawLayout {
  Index3 dims{};  // voxels along each axis
  VoxelType type = VoxelType::uint8;
};

/// What a name such as engine_256x256x128_uint8.raw states: the last "_XxYxZ_TYPE" in it.
/// Nothing if it states no such thing.
std::optional<RawLayout> layout_from_name(const std::filesystem::path& path);

/// Reads a file of exactly options.skip + voxels * bytes per voxel bytes, first axis fastest. The
/// volume's frame is `index`. Explicit options win over the name.
/// Throws InvalidArgument (layout unknown, dimensions below 1, spacing not positive),
/// LimitExceeded (more voxels than the limits allow), and InvalidInput (a file that is shorter or
/// longer, or cannot be read). Sizes are checked before memory is asked for. NaN passes.
Volume read_raw(const std::filesystem::path& path, const RawOptions& options,
                const VoxelLimits& limits = {});

/// Writes the voxels, first axis fastest, little-endian. A failure shows in the stream's state.
void write_raw(std::ostream& out, const Volume& volume);

}  // namespace isoloop
