// Voxels as small as a mesh's topology asks for.
#pragma once

#include <string>

#include "volume/base/memory_limit.h"
#include "volume/mesh/mesh.h"
#include "volume/voxelize/voxelize.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// Voxels along the mesh's longest side at which voxelize_until_counts_agree() begins; then it
/// doubles them.
inline constexpr std::int64_t first_resolution = 64;

/// Most voxels that it takes where the limits state none: 1024^3.
inline constexpr std::uint64_t most_automatic_voxels = std::uint64_t{1} << 30U;

/// voxelize() at the coarsest resolution, of 64, 128, 256 and so on, at which the level set at 0
/// has the components, tunnels and cavities that the mesh has by its triangles; a note says which.
/// If these are not known (see MeshCounts::unknown), a warning says why, and the resolution is the
/// first that has the counts of the one before. If no resolution within the limits will do, it is
/// the one whose counts come nearest to the mesh's (by the sum of the three differences; the finest
/// of equals), and a warning says which limit and all counts. Sharp edges may break into crumbs at
/// any resolution. Volume::mesh->voxels has the counts of the result.
/// Throws as voxelize() does; LimitExceeded if the first resolution is beyond the limits, and
/// InvalidArgument if `size` states a size besides.
Volume voxelize_until_counts_agree(const Mesh& mesh, const VoxelSize& size,
                                   const VoxelLimits& limits, const std::string& what);

}  // namespace isoloop
