#include "volume/base/memory_limit.h"

#include <fstream>
#include <limits>

#include "core/base/errors.h"
#include "core/base/memory_budget.h"

namespace isoloop {
namespace {

constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();

}  // namespace

std::uint64_t checked_voxel_count(const Index3& dims, const std::string& what) {
  return checked_voxel_bytes(dims, 1, what);
}

std::uint64_t checked_voxel_bytes(const Index3& dims, std::uint64_t bytes_per_voxel,
                                  const std::string& what) {
  // Stream sizes and indices are signed 64 bit.
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  std::uint64_t bytes = bytes_per_voxel;
  for (const std::int64_t dim : dims) {
    if (dim < 1) {
      throw InvalidArgument(
          {.file = what,
           .text = "dimensions " + dims_text(dims) + " make no volume; each must be at least 1"},
          Option::dims);
    }
    if (static_cast<std::uint64_t>(dim) > most / bytes) {
      throw LimitExceeded({.file = what,
                           .text = dims_text(dims) + " voxels are more than can be counted",
                           .advice = {Advice::check_dims}},
                          {.unit = Excess::Unit::voxels});
    }
    bytes *= static_cast<std::uint64_t>(dim);
  }
  return bytes;
}

std::uint64_t default_voxel_limit() {
  std::ifstream file("/proc/meminfo");
  std::string word;
  while (file >> word) {
    if (word != "MemAvailable:") continue;
    std::uint64_t kibibytes = 0;
    // 1024 * 0.8, rounded down
    if (file >> kibibytes && kibibytes < largest / 819) return kibibytes * 819;
  }
  return largest;
}

void check_voxel_memory(const Index3& dims, std::uint64_t bytes_per_voxel, std::uint64_t max_bytes,
                        const std::string& what) {
  const std::uint64_t bytes = checked_voxel_bytes(dims, bytes_per_voxel, what);
  const std::uint64_t limit = max_bytes == 0 ? default_voxel_limit() : max_bytes;
  if (bytes <= limit) return;
  throw LimitExceeded(
      {.file = what,
       .text = dims_text(dims) + " voxels of " + std::to_string(bytes_per_voxel) +
               (bytes_per_voxel == 1 ? " byte need " : " bytes need ") + bytes_text(bytes) +
               ", and the limit is " + bytes_text(limit),
       .advice = {Advice::raise_memory_limit, Advice::take_smaller_volume}},
      {.unit = Excess::Unit::bytes, .needed = bytes, .limit = limit, .stage = "read"});
}

void check_voxel_memory(const Index3& dims, std::uint64_t bytes_per_voxel,
                        const VoxelLimits& limits, const std::string& what) {
  const std::uint64_t voxels = checked_voxel_count(dims, what);
  if (limits.max_voxels > 0 && voxels > limits.max_voxels) {
    throw LimitExceeded({.file = what,
                         .text = dims_text(dims) + " are " + std::to_string(voxels) +
                                 " voxels, and the limit is " + std::to_string(limits.max_voxels),
                         .advice = {Advice::raise_voxel_limit, Advice::take_smaller_volume}},
                        {.unit = Excess::Unit::voxels,
                         .needed = voxels,
                         .limit = limits.max_voxels,
                         .stage = "read"});
  }
  check_voxel_memory(dims, bytes_per_voxel, limits.max_bytes, what);
}

std::string dims_text(const Index3& dims) {
  return std::to_string(dims[0]) + " x " + std::to_string(dims[1]) + " x " +
         std::to_string(dims[2]);
}

}  // namespace isoloop
