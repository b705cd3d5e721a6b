// What the decoder of a .vdb file sends to the process that asked for it: a header, then blocks of
// voxels, sparse as the grid is. The sender may have been led astray by a damaged file, so the
// receiver believes nothing that it has not checked.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <stdexcept>
#include <string>

#include "core/base/errors.h"
#include "volume/base/memory_limit.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// A volume before its voxels: their type is float32 or float64, `values` stays empty.
struct VdbHeader {
  Volume volume{};
  VoxelType type = VoxelType::float32;
  double background = 0.0;  // of the voxels that no block holds
};

constexpr std::int64_t leaf_side = 8;  // voxels along each side of a leaf
constexpr std::size_t leaf_voxels = 512;

/// Sends a message: one header, any number of blocks, one end; or one error alone. Corners are
/// voxel indices of the volume. A failure shows in the stream's state.
void send_header(std::ostream& out, const VdbHeader& header);
/// One value for the voxels from `low` to `high`, both included.
template <class T>
void send_tile(std::ostream& out, const Index3& low, const Index3& high, T value);
/// 8 x 8 x 8 voxels, the LAST axis fastest, from `corner` on; parts of it may lie beyond the
/// volume.
template <class T>
void send_leaf(std::ostream& out, const Index3& corner, std::span<const T, leaf_voxels> values);
void send_end(std::ostream& out);

void send_error(std::ostream& out, const InvalidArgument& error);
void send_error(std::ostream& out, const InvalidInput& error);

/// A message that ends too early or that no sender of sound mind would send.
struct BrokenMessage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Receives a volume. Work and memory are bounded by the size that the header states, and that is
/// checked against `limits` before memory is asked for; `what` opens the message of that error.
/// Throws the error that was sent (InvalidArgument, InvalidInput) with all its data, LimitExceeded,
/// and BrokenMessage.
Volume receive_volume(std::istream& in, const VoxelLimits& limits, const std::string& what);

}  // namespace isoloop
