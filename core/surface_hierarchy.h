// Coarser and coarser graphs of M: clusters of its vertices, for long distances at bounded cost.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/edge_graph.h"
#include "core/grid.h"
#include "core/surface.h"

namespace isoloop {

/// Level k of the hierarchy: the connected parts of M within blocks of 2^k grid cells a side.
struct ClusterLevel {
  std::vector<std::uint32_t> cluster_of_vertex;     // of M
  std::vector<Vec3> centers;                        // mean of the vertices; index times spacing
  std::vector<std::uint32_t> sizes;                 // vertices of M in each cluster
  std::vector<std::array<std::int32_t, 3>> blocks;  // that hold each cluster
  EdgeGraph neighbors;  // clusters joined by an edge of M; lengths between centers
};

/// Level 0: each vertex of M is a cluster.
ClusterLevel finest_level(const Surface& surface);

/// The next level: neighbours that fall into one block of twice the side become one cluster.
ClusterLevel coarser_level(const ClusterLevel& level);

}  // namespace isoloop
