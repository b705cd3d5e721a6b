#include "core/sizes/geodesic_size.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

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
constexpr double tier_radius = 8.0;   // blocks of the tier

/// Which vertices of M are closest to the ends of K's edges that are grid edges or halves of them.
struct Ends {
  const VoxelSides& sides;
  const EdgeIndex& edges;
  std::span<const std::uint32_t> closest;  // by lattice vertex

  std::uint32_t upper_end(std::uint32_t edge) const {
    return edge / 3 + sides.lattice.stride[edge % 3];
  }
  bool is_cut(std::uint32_t edge) const {
    return sides.inside[edge / 3] != sides.inside[upper_end(edge)];
  }

  /// Of a cut edge: of its inside half.
  std::array<std::uint32_t, 2> of(std::uint32_t edge) const {
    const std::uint32_t v = edge / 3;
    const std::uint32_t w = upper_end(edge);
    if (!is_cut(edge)) return {closest[v], closest[w]};
    return {closest[sides.is_on(Side::inside, v) ? v : w], edges.vertex_on(edge)};
  }

  std::array<std::uint32_t, 2> of_outside_half(std::uint32_t edge) const {
    const std::uint32_t v = edge / 3;
    return {closest[sides.is_on(Side::outside, v) ? v : upper_end(edge)], edges.vertex_on(edge)};
  }

  /// Whether a full edge of lesser number and the same direction, next to this one in the numbering
  /// of the lattice, has the same ends: most do, for what is closest to one vertex of M is long and
  /// thin. `not_zero`: edges_of_size(). It tells what is an edge of the box: at the box's border
  /// the next number may be none.
  bool are_those_of_a_lesser(std::uint32_t edge, const std::array<std::uint32_t, 2>& ends,
                             const EdgeSet& not_zero) const {
    for (const std::uint32_t step : sides.lattice.stride) {
      if (edge / 3 < step) return false;
      const std::uint32_t beside = edge - 3 * step;
      if (closest[beside / 3] == ends[0] && not_zero[beside] &&
          closest[upper_end(beside)] == ends[1] && !is_cut(beside))
        return true;
    }
    return false;
  }
};

/// The edges whose size is not 0, but for outside halves.
EdgeSet edges_of_size(const Ends& ends) {
  const Lattice& lattice = ends.sides.lattice;
  return EdgeSet(lattice.vertex_count(), [&](std::uint32_t block) {
    EdgeSet::BlockBits not_zero{};
    const std::uint32_t end = std::min(64 * block + 64, lattice.vertex_count());
    auto position = lattice.position(64 * block);
    for (std::uint32_t v = 64 * block; v < end; ++v) {
      for (std::uint32_t a = 0; a < 3; ++a) {
        if (position[a] + 1 == lattice.dims[a]) continue;
        const std::uint32_t w = v + lattice.stride[a];
        const bool is_full = ends.sides.inside[v] == ends.sides.inside[w];
        const bool differ = ends.closest[v] != ends.closest[w];
        not_zero[a] |= std::uint64_t{is_full && differ} << (v % 64);
      }
      for (int a = 0; a < 3 && ++position[a] == lattice.dims[a]; ++a) position[a] = 0;
    }
    ends.edges.visit_block(block, [&](std::uint32_t, std::uint32_t edge) {
      const auto [a, b] = ends.of(edge);
      not_zero[edge % 3] |= std::uint64_t{a != b} << (edge / 3 % 64);
    });
    return not_zero;
  });
}

/// Calls visit(a, b) for the pairs of ends that are to be searched for, some of them repeatedly,
/// and from many threads.
template <class Visit>
void for_each_pair_of_ends(const Ends& ends, const EdgeSet& not_zero, const Surface& surface,
                           const Visit& visit) {
  const auto& component = surface.component_of_vertex;
  tbb::parallel_for(std::uint32_t{0}, not_zero.block_count(), [&](std::uint32_t block) {
    not_zero.visit_block(block, [&](std::uint32_t, std::uint32_t edge) {
      const auto pair = ends.of(edge);
      if (component[pair[0]] == component[pair[1]] &&
          !ends.are_those_of_a_lesser(edge, pair, not_zero))
        visit(pair[0], pair[1]);
    });
    ends.edges.visit_block(block, [&](std::uint32_t, std::uint32_t edge) {
      const auto [a, b] = ends.of_outside_half(edge);
      if (a != b && component[a] == component[b]) visit(a, b);
    });
  });
}

VertexPairs collect_pairs(const Ends& ends, const EdgeSet& not_zero, const Surface& surface) {
  PairCollector collector(static_cast<std::uint32_t>(surface.points.size()));
  for_each_pair_of_ends(ends, not_zero, surface,
                        [&](std::uint32_t a, std::uint32_t b) { collector.count(a, b); });
  collector.end_of_counting();
  for_each_pair_of_ends(ends, not_zero, surface,
                        [&](std::uint32_t a, std::uint32_t b) { collector.add(a, b); });
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

/// A pair without a length.
struct OpenPair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t position = 0;  // in VertexPairs::partner
};

std::vector<OpenPair> open_pairs(const VertexPairs& pairs, const std::vector<float>& lengths) {
  std::vector<OpenPair> open;
  for (std::uint32_t a = 0; a < pairs.source_count(); ++a)
    for (std::uint32_t i = pairs.first[a]; i < pairs.first[a + 1]; ++i)
      if (lengths[i] == unknown) open.push_back({a, pairs.partner[i], i});
  return open;
}

/// Lengths between clusters for the open pairs; none comes out below `least`, which the tier
/// before has searched in vain, nor below the straight line. Returns those that stay open.
std::vector<OpenPair> search_tier(const Surface& surface, const ClusterTier& tier, double least,
                                  double block, std::vector<OpenPair> open,
                                  std::vector<float>& lengths) {
  const auto& cluster = tier.cluster_of_vertex;
  PairCollector collector(static_cast<std::uint32_t>(tier.centers.size()));
  const auto set_length = [&](const OpenPair& pair, float found) {
    const double line = distance(scaled_point(surface, pair.a), scaled_point(surface, pair.b));
    lengths[pair.position] = std::max(found, static_cast<float>(std::max(least, line)));
  };
  std::erase_if(open, [&](const OpenPair& pair) {
    if (cluster[pair.a] != cluster[pair.b]) return false;
    set_length(pair, 0.0F);
    return true;
  });
  for (const OpenPair& pair : open) collector.count(cluster[pair.a], cluster[pair.b]);
  collector.end_of_counting();
  for (const OpenPair& pair : open) collector.add(cluster[pair.a], cluster[pair.b]);
  const VertexPairs between = collector.take();
  std::vector<float> distances(between.partner.size(), unknown);
  search_pairs(tier.neighbors, tier.centers, between, tier_radius * block, block / 2, distances);
  std::erase_if(open, [&](const OpenPair& pair) {
    const float found = distances[between.find(cluster[pair.a], cluster[pair.b])];
    if (found == unknown) return false;
    set_length(pair, found);
    return true;
  });
  return open;
}

/// Blocks of the last are larger than any volume, whose sides are at most 2^20 times 10^36 (the
/// largest spacing over the least) voxels.
constexpr int most_tiers = 150;

std::vector<float> pair_lengths(const Surface& surface, const VertexPairs& pairs,
                                GeodesicMode mode) {
  std::vector<float> lengths(pairs.partner.size(), unknown);
  ClusterTier tier = finest_tier(surface);
  const double voxel = block_side(surface.spacing);
  if (mode == GeodesicMode::exact) {
    // Tall voxels have edges far longer than wide ones.
    const auto& edges = surface.graph.lengths;
    const float longest = edges.empty() ? 0.0F : *std::max_element(edges.begin(), edges.end());
    const double bucket = std::max(voxel / 2, longest / 32.0);
    search_pairs(surface.graph, tier.centers, pairs, infinite, bucket, lengths);
    return lengths;
  }
  double searched = exact_radius * voxel;
  search_pairs(surface.graph, tier.centers, pairs, searched, voxel / 2, lengths);
  int tiers = 0;
  std::vector<OpenPair> open = open_pairs(pairs, lengths);
  const EdgeGraph* neighbors = &surface.graph;
  for (double block = 2 * voxel; !open.empty(); block *= 2) {
    if (++tiers > most_tiers)
      throw SelfCheckFailed("sizes are still unknown where clusters are as large as the volume");
    tier = coarser_tier(tier, *neighbors);
    neighbors = &tier.neighbors;
    open = search_tier(surface, tier, searched, block, std::move(open), lengths);
    searched = tier_radius * block;
  }
  return lengths;
}

}  // namespace

EdgeSizes geodesic_sizes(const VoxelSides& sides, const EdgeIndex& edges, const Surface& surface,
                         std::span<const std::uint32_t> closest, GeodesicMode mode) {
  const Ends ends{sides, edges, closest};
  EdgeSet not_zero = edges_of_size(ends);
  const VertexPairs pairs = collect_pairs(ends, not_zero, surface);
  const std::vector<float> lengths = pair_lengths(surface, pairs, mode);
  const auto& component = surface.component_of_vertex;
  const auto size_of = [&](const std::array<std::uint32_t, 2>& ends_of_edge) {
    const auto [a, b] = ends_of_edge;
    if (a == b) return 0.0F;
    return component[a] != component[b] ? infinite : lengths[pairs.find(a, b)];
  };
  EdgeSizes sizes;
  sizes.by_edge = SparseSizes(std::move(not_zero));
  sizes.by_edge.set_all([&](std::uint32_t edge) { return size_of(ends.of(edge)); });
  sizes.of_outside_half.resize(surface.points.size());
  tbb::parallel_for(std::uint32_t{0}, edges.block_count(), [&](std::uint32_t block) {
    edges.visit_block(block, [&](std::uint32_t vertex, std::uint32_t edge) {
      sizes.of_outside_half[vertex] = size_of(ends.of_outside_half(edge));
    });
  });
  return sizes;
}

}  // namespace isoloop
