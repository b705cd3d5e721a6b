// For each grid vertex, or each vertex of an octree, the vertex of M that is closest to it.
#pragma once

#include <cstdint>

#include "core/base/unset_vector.h"
#include "core/cube/voxel_sides.h"
#include "core/octree/octree.h"
#include "core/surface/edge_index.h"
#include "core/surface/surface.h"

namespace isoloop {

/// Exact in Euclidean distance (unit of the spacing), up to single precision; a separable lower
/// envelope of parabolas (Felzenszwalb and Huttenlocher, Theory of Computing 8, 2012) for the
/// vertices of M on edges along each axis. Result by lattice vertex; linear time. M not empty.
UnsetVector<std::uint32_t> closest_surface_vertices(const VoxelSides& sides, const EdgeIndex& edges,
                                                    const Surface& surface);

/// The same for the vertices of an octree, one by one; of several as close, the first. Exact.
UnsetVector<std::uint32_t> closest_surface_vertices(const Octree& octree, const Surface& surface);

}  // namespace isoloop
