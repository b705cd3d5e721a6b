#include "core/surface_hierarchy.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/disjoint_sets.h"

namespace isoloop {
namespace {

using Arc = std::pair<std::uint32_t, std::uint32_t>;

/// Straight lengths between centers on the given arcs; repetitions are dropped.
EdgeGraph graph_of(std::vector<Arc> arcs, const std::vector<Vec3>& centers) {
  std::sort(arcs.begin(), arcs.end());
  arcs.erase(std::unique(arcs.begin(), arcs.end()), arcs.end());
  EdgeGraph graph;
  graph.csr = EdgeGraph::Csr(boost::edges_are_sorted, arcs.begin(), arcs.end(),
                             static_cast<std::uint32_t>(centers.size()));
  graph.lengths.resize(arcs.size());
  for (std::size_t i = 0; i < arcs.size(); ++i)
    graph.lengths[i] =
        static_cast<float>(distance(centers[arcs[i].first], centers[arcs[i].second]));
  return graph;
}

/// Joins neighbours whose blocks are equal once halved; numbers the results by their least member.
std::vector<std::uint32_t> parents(const ClusterLevel& level, std::uint32_t& count) {
  const auto clusters = static_cast<std::uint32_t>(level.centers.size());
  const auto halved = [&](std::uint32_t c) {
    const auto& b = level.blocks[c];
    return std::array<std::int32_t, 3>{b[0] >> 1, b[1] >> 1, b[2] >> 1};
  };
  DisjointSets sets(clusters);
  for (std::uint32_t c = 0; c < clusters; ++c)
    level.neighbors.for_each_out_edge(c, [&](std::uint32_t next, std::uint32_t) {
      if (next > c && halved(c) == halved(next)) sets.unite(c, next);
    });
  std::vector<std::uint32_t> parent(clusters);
  count = 0;
  for (std::uint32_t c = 0; c < clusters; ++c) {
    const std::uint32_t root = sets.find(c);
    parent[c] = root == c ? count++ : parent[root];
  }
  return parent;
}

}  // namespace

ClusterLevel finest_level(const Surface& surface) {
  const auto count = static_cast<std::uint32_t>(surface.points.size());
  ClusterLevel level;
  level.cluster_of_vertex.resize(count);
  level.centers.resize(count);
  level.sizes.assign(count, 1);
  level.blocks.resize(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    level.cluster_of_vertex[v] = v;
    level.centers[v] = scaled_point(surface, v);
    for (int a = 0; a < 3; ++a)
      level.blocks[v][a] = static_cast<std::int32_t>(std::floor(surface.points[v][a]));
  }
  level.neighbors = surface.graph;
  return level;
}

ClusterLevel coarser_level(const ClusterLevel& level) {
  std::uint32_t count = 0;
  const std::vector<std::uint32_t> parent = parents(level, count);
  ClusterLevel coarse;
  coarse.centers.resize(count);
  coarse.sizes.resize(count);
  coarse.blocks.resize(count);
  for (std::size_t c = 0; c < parent.size(); ++c) {
    const std::uint32_t p = parent[c];
    coarse.sizes[p] += level.sizes[c];
    for (int a = 0; a < 3; ++a) {
      coarse.centers[p][a] += level.centers[c][a] * level.sizes[c];
      coarse.blocks[p][a] = level.blocks[c][a] >> 1;
    }
  }
  for (std::uint32_t p = 0; p < count; ++p)
    for (double& x : coarse.centers[p]) x /= coarse.sizes[p];
  coarse.cluster_of_vertex.reserve(level.cluster_of_vertex.size());
  for (const std::uint32_t c : level.cluster_of_vertex)
    coarse.cluster_of_vertex.push_back(parent[c]);
  std::vector<Arc> arcs;
  for (std::uint32_t c = 0; c < parent.size(); ++c)
    level.neighbors.for_each_out_edge(c, [&](std::uint32_t next, std::uint32_t) {
      if (parent[c] != parent[next]) arcs.emplace_back(parent[c], parent[next]);
    });
  coarse.neighbors = graph_of(std::move(arcs), coarse.centers);
  return coarse;
}

}  // namespace isoloop
