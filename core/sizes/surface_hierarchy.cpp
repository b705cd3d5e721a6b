#include "core/sizes/surface_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tbb/parallel_for.h>

#include "core/base/compressed_rows.h"
#include "core/base/disjoint_sets.h"

namespace isoloop {
namespace {

/// An edge from `source` to each value of its row, as long as the straight line between centers.
EdgeGraph graph_of(const CompressedRows& targets, const std::vector<Vec3>& centers) {
  const auto count = static_cast<std::uint32_t>(centers.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> arcs(targets.values.size());
  EdgeGraph graph;
  graph.lengths.resize(arcs.size());
  tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t source) {
    for (std::uint32_t i = targets.first[source]; i < targets.first[source + 1]; ++i) {
      arcs[i] = {source, targets.values[i]};
      graph.lengths[i] = static_cast<float>(distance(centers[source], centers[targets.values[i]]));
    }
  });
  graph.csr = EdgeGraph::Csr(boost::edges_are_sorted, arcs.begin(), arcs.end(), count,
                             static_cast<std::uint32_t>(arcs.size()));
  return graph;
}

/// Joins neighbours whose blocks are equal once halved; numbers the results by their least member.
std::vector<std::uint32_t> parents(const ClusterTier& tier, const EdgeGraph& neighbors,
                                   std::uint32_t& count) {
  const auto clusters = static_cast<std::uint32_t>(tier.centers.size());
  const auto halved = [&](std::uint32_t c) {
    const auto& b = tier.blocks[c];
    return std::array<std::int32_t, 3>{b[0] >> 1, b[1] >> 1, b[2] >> 1};
  };
  DisjointSets sets(clusters);
  tbb::parallel_for(std::uint32_t{0}, clusters, [&](std::uint32_t c) {
    neighbors.for_each_out_edge(c, [&](std::uint32_t next, std::uint32_t) {
      if (next > c && halved(c) == halved(next)) sets.unite_shared(c, next);
    });
  });
  std::vector<std::uint32_t> parent(clusters);
  count = 0;
  for (std::uint32_t c = 0; c < clusters; ++c) {
    const std::uint32_t root = sets.find(c);
    parent[c] = root == c ? count++ : parent[root];
  }
  return parent;
}

/// Of each of `count` parents, those of the neighbours of its children.
CompressedRows neighbors_of(const EdgeGraph& graph, const std::vector<std::uint32_t>& parent,
                            std::uint32_t count) {
  return collected_rows(count, [&](const auto& visit) {
    tbb::parallel_for(std::uint32_t{0}, graph.vertex_count(), [&](std::uint32_t c) {
      graph.for_each_out_edge(c, [&](std::uint32_t next, std::uint32_t) {
        if (parent[c] != parent[next]) visit(parent[c], parent[next]);
      });
    });
  });
}

}  // namespace

double block_side(const Vec3& spacing) {
  constexpr double most_of_least = 4.0;
  const auto [least, most] = std::minmax({spacing[0], spacing[1], spacing[2]});
  if (least == most) return least;
  return std::min(std::cbrt(spacing[0] * spacing[1] * spacing[2]), most_of_least * least);
}

ClusterTier finest_tier(const Surface& surface) {
  constexpr double most_blocks = 1024.0;  // a voxel: block numbers fit 32 bits
  const double side = block_side(surface.spacing);
  Vec3 blocks_per_voxel{};
  for (std::size_t a = 0; a < 3; ++a)
    blocks_per_voxel[a] = std::min(surface.spacing[a] / side, most_blocks);
  const auto count = static_cast<std::uint32_t>(surface.points.size());
  ClusterTier tier;
  tier.cluster_of_vertex.resize(count);
  tier.centers.resize(count);
  tier.sizes.assign(count, 1);
  tier.blocks.resize(count);
  tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t v) {
    tier.cluster_of_vertex[v] = v;
    tier.centers[v] = scaled_point(surface, v);
    for (int a = 0; a < 3; ++a)
      tier.blocks[v][a] =
          static_cast<std::int32_t>(std::floor(surface.points[v][a] * blocks_per_voxel[a]));
  });
  return tier;
}

ClusterTier coarser_tier(const ClusterTier& tier, const EdgeGraph& neighbors) {
  std::uint32_t count = 0;
  const std::vector<std::uint32_t> parent = parents(tier, neighbors, count);
  ClusterTier coarse;
  coarse.centers.resize(count);
  coarse.sizes.resize(count);
  coarse.blocks.resize(count);
  for (std::size_t c = 0; c < parent.size(); ++c) {
    const std::uint32_t p = parent[c];
    coarse.sizes[p] += tier.sizes[c];
    for (int a = 0; a < 3; ++a) {
      coarse.centers[p][a] += tier.centers[c][a] * tier.sizes[c];
      coarse.blocks[p][a] = tier.blocks[c][a] >> 1;
    }
  }
  for (std::uint32_t p = 0; p < count; ++p)
    for (double& x : coarse.centers[p]) x /= coarse.sizes[p];
  coarse.cluster_of_vertex.resize(tier.cluster_of_vertex.size());
  tbb::parallel_for(std::size_t{0}, coarse.cluster_of_vertex.size(), [&](std::size_t v) {
    coarse.cluster_of_vertex[v] = parent[tier.cluster_of_vertex[v]];
  });
  coarse.neighbors = graph_of(neighbors_of(neighbors, parent, count), coarse.centers);
  return coarse;
}

}  // namespace isoloop
