// Voxels as files store them: any byte order, 64-bit integers, a slope and an intercept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "volume/base/byte_order.h"
#include "volume/base/byte_stream.h"
#include "volume/base/memory_limit.h"
#include "volume/voxels/crop.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// Types that files hold: those of VoxelType in its order, and integers of 64 bits, which are read
/// as 32 bits if every voxel fits.
enum class StoredType {
  uint8,
  int8,
  uint16,
  int16,
  uint32,
  int32,
  float32,
  float64,
  int64,
  uint64
};

/// 1, 2, 4 or 8.
std::uint64_t bytes_per_voxel(StoredType type);

/// The type of integers of so many bytes (1, 2, 4, 8), and of floating-point numbers (4, 8);
/// nothing for other sizes.
std::optional<StoredType> integer_type(std::uint64_t bytes, bool is_signed);
std::optional<StoredType> float_type(std::uint64_t bytes);

/// What a header says of its voxels: `frames` blocks of dims[0] * dims[1] * dims[2], one after the
/// other, first axis fastest.
struct VoxelLayout {
  Index3 dims{1, 1, 1};
  StoredType type = StoredType::uint8;
  Endian endian = Endian::little;
  std::uint64_t frames = 1;
  double slope = 1.0;  // value = slope * stored + intercept
  double intercept = 0.0;
  std::optional<VoxelBox> part{};  // the voxels of a frame to keep; unset: all
};

/// Throws as checked_voxel_bytes and check_voxel_memory do, of what reading `layout`, or the part
/// of it, will take at its end: InvalidInput instead of InvalidArgument, since a header states the
/// dimensions.
void check_layout(const VoxelLayout& layout, const VoxelLimits& limits, const std::string& what);

/// The frame to read. Throws InvalidArgument if there are several and none is asked for, or if the
/// one asked for is not there.
std::uint64_t choose_frame(const VoxelLayout& layout, const std::optional<std::int64_t>& frame,
                           const std::string& what);

/// Reads all frames and keeps the values of one, and where they are; the stream must end after
/// them. `volume` has the frame's dims and place; with layout.part it becomes that part, and no
/// others of a plain stream's bytes need be read. Checks check_layout() and the bytes that are
/// there before it asks for memory. Throws InvalidInput (bytes are missing, damaged or too many,
/// integers of 64 bits that do not fit).
void read_voxels(ByteStream& stream, const VoxelLayout& layout, std::uint64_t frame,
                 const VoxelLimits& limits, const std::string& what, Volume& volume);

/// Fills a span with the next stored bytes, or throws.
using ByteSource = std::function<void(std::span<std::byte>)>;

/// One frame's values as stored, unscaled. The caller has checked the layout. Throws InvalidInput
/// (integers of 64 bits that do not fit) and what `next` throws.
VoxelArray read_stored(const ByteSource& next, const VoxelLayout& layout, const std::string& what);

/// Notes slope and intercept in the volume, unless they change nothing.
void add_scale_note(const VoxelLayout& layout, Volume& volume);

/// slope * value + intercept. Whole numbers stay exact integers, in the smallest of int16, int32
/// and uint32 that holds them; other values become float32, or float64 from 32-bit integers and
/// float64. A slope of 1 with an intercept of 0 leaves the type. Throws InvalidInput if either is
/// not finite or the slope is 0.
VoxelArray rescaled(VoxelArray values, double slope, double intercept, const std::string& what);

}  // namespace isoloop
