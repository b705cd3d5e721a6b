// How much memory voxels may take: asked before anything is allocated or read.
#pragma once

#include <cstdint>
#include <string>

#include "core/grid/grid.h"

namespace isoloop {

/// What a volume may take; checked before anything is allocated.
struct VoxelLimits {
  std::uint64_t max_bytes = 0;   // of voxels; 0: default_voxel_limit()
  std::uint64_t max_voxels = 0;  // 0: no bound of its own
};

/// dims[0] * dims[1] * dims[2]. `what` (a file or shape name) opens the message of an error.
/// Throws InvalidArgument if a dimension is below 1, LimitExceeded if the product does not fit.
std::uint64_t checked_voxel_count(const Index3& dims, const std::string& what);

/// 80 % of the memory that the system calls available, in bytes; the largest number if it says
/// nothing.
std::uint64_t default_voxel_limit();

/// Bytes of dims[0] * dims[1] * dims[2] voxels. Throws as checked_voxel_count does.
std::uint64_t checked_voxel_bytes(const Index3& dims, std::uint64_t bytes_per_voxel,
                                  const std::string& what);

/// Throws as checked_voxel_bytes does, and LimitExceeded if the voxels take more than `max_bytes`
/// (0: default_voxel_limit()).
void check_voxel_memory(const Index3& dims, std::uint64_t bytes_per_voxel, std::uint64_t max_bytes,
                        const std::string& what);

/// The same, and LimitExceeded for more than limits.max_voxels voxels.
void check_voxel_memory(const Index3& dims, std::uint64_t bytes_per_voxel,
                        const VoxelLimits& limits, const std::string& what);

/// "256 x 256 x 128".
std::string dims_text(const Index3& dims);

}  // namespace isoloop
