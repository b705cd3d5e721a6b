// Raw volumes: voxels and nothing else, so size and type come from the name or the caller.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>

#include "isoloop/read.h"
#include "isoloop/volume.h"
#include "volume/base/memory_limit.h"

namespace isoloop {

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

/// Calls `take` with the voxels' bytes in that order, once or piece by piece.
void for_each_little_endian(const VoxelArray& values,
                            const std::function<void(std::span<const std::byte>)>& take);

/// Writes the voxels, first axis fastest, little-endian. A failure shows in the stream's state.
void write_raw(std::ostream& out, const Volume& volume);

}  // namespace isoloop
