#include "core/sizes/sizes_by_ends.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/base/errors.h"
#include "core/base/per_thread.h"
#include "core/sizes/bounded_search.h"
#include "core/sizes/surface_hierarchy.h"

namespace isoloop {
namespace {

constexpr float unknown = -1.0F;
constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr double exact_radius = 5.0;  // voxels
constexpr double tier_radius = 8.0;   // blocks of the tier

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

void SizesByEnds::search(GeodesicMode mode) { lengths_ = pair_lengths(surface_, pairs_, mode); }

float SizesByEnds::of(const Ends& ends) const {
  if (ends[0] == ends[1]) return 0.0F;
  return are_on_one_component(ends) ? lengths_[pairs_.find(ends[0], ends[1])] : infinite;
}

}  // namespace isoloop
