// Coarser and coarser graphs of M: clusters of its vertices, for long distances at bounded cost.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/grid/grid.h"
#include "core/surface/edge_graph.h"
#include "core/surface/surface.h"

namespace isoloop {

/// The side of a block of tier 0, unit of the spacing: a voxel's, in the mean of its axes, but no
/// more than four times the least of them. A search that reached as far as voxels are tall would go
/// round most of M across them.
double block_side(const Vec3& spacing);

/// Tier k of the hierarchy: the connected parts of M within blocks of 2^k block_side() a side (of
/// fewer along an axis whose voxels are more than a thousand times as long).
struct ClusterTier {
  std::vector<std::uint32_t> cluster_of_vertex;     // of M
  std::vector<Vec3> centers;                        // mean of the vertices; index times spacing
  std::vector<std::uint32_t> sizes;                 // vertices of M in each cluster
  std::vector<std::array<std::int32_t, 3>> blocks;  // that hold each cluster
  EdgeGraph neighbors;  // clusters joined by an edge of M; lengths between centers
};

/// Tier 0: each vertex of M is a cluster. Its neighbors are M's graph, of which it has no copy.
ClusterTier finest_tier(const Surface& surface);

/// The next tier: neighbours that fall into one block of twice the side become one cluster.
/// `neighbors`: those of `tier`.
ClusterTier coarser_tier(const ClusterTier& tier, const EdgeGraph& neighbors);

}  // namespace isoloop
