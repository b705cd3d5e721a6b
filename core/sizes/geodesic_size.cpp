#include "core/sizes/geodesic_size.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/base/errors.h"
#include "core/base/per_thread.h"
#include "core/sizes/bounded_search.h"
#include "core/sizes/surface_hierarchy.h"
#include "core/sizes/vertex_pairs.h"

namespace isoloop {
namespace {

constexpr float unknown = -1.0F;
constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr double exact_radius = 5.0;  // voxels
constexpr double level_radius = 8.0;  // blocks of the level

/// Calls visit(edge, is_outside_half, a, b) for K's edges that are grid edges at lattice vertices
/// 64 block .. 64 block + 63, or halves of them: a and b are the surface vertices closest to its
/// ends.
template <class Visit>
void visit_end_pairs(const VoxelSides& sides, const EdgeIndex& edges,
                     std::span<const std::uint32_t> closest, std::uint32_t block,
                     const Visit& visit) {
  const Lattice& lattice = sides.lattice;
  const std::uint32_t end = std::min(64 * block + 64, lattice.vertex_count());
  auto position = lattice.position(64 * block);
  for (std::uint32_t v = 64 * block; v < end; ++v) {
    for (std::uint32_t a = 0; a < 3; ++a) {
      if (position[a] + 1 == lattice.dims[a]) continue;
      const std::uint32_t w = v + lattice.stride[a];
      const std::uint32_t edge = 3 * v + a;
      if (sides.inside[v] == sides.inside[w]) {
        visit(edge, false, closest[v], closest[w]);
      } else {
        const std::uint32_t crossing = edges.vertex_on(edge);
        visit(edge, sides.is_on(Side::outside, v), closest[v], crossing);
        visit(edge, sides.is_on(Side::outside, w), closest[w], crossing);
      }
    }
    for (int a = 0; a < 3 && ++position[a] == lattice.dims[a]; ++a) position[a] = 0;
  }
}

/// The same for all blocks, many at a time.
template <class Visit>
void for_each_end_pair(const VoxelSides& sides, const EdgeIndex& edges,
                       std::span<const std::uint32_t> closest, const Visit& visit) {
  tbb::parallel_for(std::uint32_t{0}, edges.block_count(), [&](std::uint32_t block) {
    visit_end_pairs(sides, edges, closest, block, visit);
  });
}

VertexPairs collect_pairs(const VoxelSides& sides, const EdgeIndex& edges, const Surface& surface,
                          std::span<const std::uint32_t> closest) {
  const auto& component = surface.component_of_vertex;
  PairCollector collector(static_cast<std::uint32_t>(surface.points.size()));
  const auto matters = [&](std::uint32_t a, std::uint32_t b) {
    return a != b && component[a] == component[b];
  };
  for_each_end_pair(sides, edges, closest,
                    [&](std::uint32_t, bool, std::uint32_t a, std::uint32_t b) {
                      if (matters(a, b)) collector.count(a, b);
                    });
  collector.end_of_counting();
  for_each_end_pair(sides, edges, closest,
                    [&](std::uint32_t, bool, std::uint32_t a, std::uint32_t b) {
                      if (matters(a, b)) collector.add(a, b);
                    });
  return collector.take();
}

/// What is asked of a search from `source`: the partners without a length that may be within
/// `radius`. An edge to a partner is the shortest path to it, and no path is shorter than the
/// straight line.
void set_goals(const EdgeGraph& graph, const std::vector<Vec3>& points, const VertexPairs& pairs,
               std::uint32_t source, double radius, std::vector<float>& lengths,
               std::vector<Goal>& goals) {
  goals.clear();
  for (std::uint32_t i = pairs.first[source]; i < pairs.first[source + 1]; ++i) {
    if (lengths[i] != unknown) continue;
    const std::uint32_t partner = pairs.partner[i];
    const std::uint32_t edge = edge_between(graph, source, partner);
    if (edge != no_edge)
      lengths[i] = graph.lengths[edge];
    else if (distance(points[source], points[partner]) <= radius)
      goals.push_back({partner});
  }
}

/// Fills in the distances up to `radius` between the partners that are still unknown; `bucket` is
/// that of BoundedSearch.
void search_pairs(const EdgeGraph& graph, const std::vector<Vec3>& points, const VertexPairs& pairs,
                  double radius, double bucket, std::vector<float>& lengths) {
  struct Worker {
    BoundedSearch search;
    std::vector<Goal> goals{};
  };
  PerThread<Worker> workers;
  const tbb::blocked_range<std::uint32_t> sources(0, pairs.source_count(), 64);
  tbb::parallel_for(sources, [&](const auto& range) {
    auto& [search, goals] =
        workers.local([&] { return Worker{BoundedSearch(graph, points, radius, bucket)}; });
    for (std::uint32_t source = range.begin(); source < range.end(); ++source) {
      set_goals(graph, points, pairs, source, radius, lengths, goals);
      if (goals.empty()) continue;
      search.run(source, goals);
      for (const Goal& goal : goals)
        if (goal.length != infinite) lengths[pairs.find(source, goal.vertex)] = goal.length;
    }
  });
}

/// Calls visit(a, b, length) for each pair; a is the lesser.
template <class Visit>
void for_each_pair(const VertexPairs& pairs, std::vector<float>& lengths, const Visit& visit) {
  tbb::parallel_for(std::uint32_t{0}, pairs.source_count(), [&](std::uint32_t a) {
    for (std::uint32_t i = pairs.first[a]; i < pairs.first[a + 1]; ++i)
      visit(a, pairs.partner[i], lengths[i]);
  });
}

/// Lengths between clusters for the open pairs; none comes out below `least`, which the level
/// before has searched in vain, nor below the straight line.
void search_level(const Surface& surface, const ClusterLevel& level, const VertexPairs& pairs,
                  double least, double block, std::vector<float>& lengths) {
  const double radius = level_radius * block;
  const double bucket = block / 2;
  const auto& cluster = level.cluster_of_vertex;
  PairCollector collector(static_cast<std::uint32_t>(level.centers.size()));
  const auto at_least = [&](std::uint32_t a, std::uint32_t b) {
    const double line = distance(scaled_point(surface, a), scaled_point(surface, b));
    return static_cast<float>(std::max(least, line));
  };
  const auto settle_or = [&](const auto& use) {
    for_each_pair(pairs, lengths, [&](std::uint32_t a, std::uint32_t b, float& length) {
      if (length != unknown) return;
      if (cluster[a] == cluster[b])
        length = at_least(a, b);
      else
        use(a, b, length);
    });
  };
  settle_or(
      [&](std::uint32_t a, std::uint32_t b, float&) { collector.count(cluster[a], cluster[b]); });
  collector.end_of_counting();
  settle_or(
      [&](std::uint32_t a, std::uint32_t b, float&) { collector.add(cluster[a], cluster[b]); });
  const VertexPairs between = collector.take();
  std::vector<float> distances(between.partner.size(), unknown);
  search_pairs(level.neighbors, level.centers, between, radius, bucket, distances);
  settle_or([&](std::uint32_t a, std::uint32_t b, float& length) {
    const float found = distances[between.find(cluster[a], cluster[b])];
    if (found != unknown) length = std::max(found, at_least(a, b));
  });
}

/// Blocks of the last are larger than any volume, whose sides are at most 2^20 times 10^36 (the
/// largest spacing over the least) voxels.
constexpr int most_levels = 150;

std::vector<float> pair_lengths(const Surface& surface, const VertexPairs& pairs,
                                GeodesicMode mode) {
  std::vector<float> lengths(pairs.partner.size(), unknown);
  ClusterLevel level = finest_level(surface);
  const double voxel = block_side(surface.spacing);
  if (mode == GeodesicMode::exact) {
    // Tall voxels have edges far longer than wide ones.
    const auto& edges = surface.graph.lengths;
    const float longest = edges.empty() ? 0.0F : *std::max_element(edges.begin(), edges.end());
    const double bucket = std::max(voxel / 2, longest / 32.0);
    search_pairs(surface.graph, level.centers, pairs, infinite, bucket, lengths);
    return lengths;
  }
  double searched = exact_radius * voxel;
  search_pairs(surface.graph, level.centers, pairs, searched, voxel / 2, lengths);
  int levels = 0;
  for (double block = 2 * voxel;
       std::find(lengths.begin(), lengths.end(), unknown) != lengths.end(); block *= 2) {
    if (++levels > most_levels)
      throw SelfCheckFailed("sizes are still unknown where clusters are as large as the volume");
    level = coarser_level(level);
    search_level(surface, level, pairs, searched, block, lengths);
    searched = level_radius * block;
  }
  return lengths;
}

/// The edges whose size is not 0, but for outside halves.
EdgeSet edges_of_size(const VoxelSides& sides, const EdgeIndex& edges,
                      std::span<const std::uint32_t> closest) {
  return EdgeSet(sides.lattice.vertex_count(), [&](std::uint32_t block) {
    EdgeSet::BlockBits not_zero{};
    visit_end_pairs(
        sides, edges, closest, block,
        [&](std::uint32_t edge, bool is_outside_half, std::uint32_t a, std::uint32_t b) {
          if (is_outside_half || a == b) return;
          not_zero[edge % 3] |= std::uint64_t{1} << (edge / 3 % 64);
        });
    return not_zero;
  });
}

}  // namespace

EdgeSizes geodesic_sizes(const VoxelSides& sides, const EdgeIndex& edges, const Surface& surface,
                         std::span<const std::uint32_t> closest, GeodesicMode mode) {
  const VertexPairs pairs = collect_pairs(sides, edges, surface, closest);
  const std::vector<float> lengths = pair_lengths(surface, pairs, mode);
  const auto& component = surface.component_of_vertex;
  EdgeSizes sizes;
  sizes.by_edge = SparseSizes(edges_of_size(sides, edges, closest));
  sizes.of_outside_half.resize(surface.points.size());
  for_each_end_pair(
      sides, edges, closest,
      [&](std::uint32_t edge, bool is_outside_half, std::uint32_t a, std::uint32_t b) {
        if (a == b) return;
        const float size = component[a] != component[b] ? infinite : lengths[pairs.find(a, b)];
        if (is_outside_half)
          sizes.of_outside_half[edges.vertex_on(edge)] = size;
        else
          sizes.by_edge.set(edge, size);
      });
  return sizes;
}

}  // namespace isoloop
