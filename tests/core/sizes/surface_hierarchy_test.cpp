#include "core/sizes/surface_hierarchy.h"

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "core/base/disjoint_sets.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

TEST(SurfaceHierarchy, ClustersAreTheConnectedPartsOfBlocks) {
  const testing::Prepared p(testing::smooth_noise({18, 17, 16}, 3, 1), GeodesicMode::hierarchy);
  const Surface& surface = p.surface;
  ClusterTier tier = finest_tier(surface);
  const EdgeGraph* neighbors = &surface.graph;
  for (int k = 1; k <= 3; ++k) {
    tier = coarser_tier(tier, *neighbors);
    neighbors = &tier.neighbors;
    const auto block = [&](std::uint32_t v) {
      std::array<std::int64_t, 3> b{};
      for (int a = 0; a < 3; ++a)
        b[a] = static_cast<std::int64_t>(std::floor(surface.points[v][a])) >> k;
      return b;
    };
    DisjointSets parts(surface.graph.vertex_count());
    for (std::uint32_t u = 0; u < surface.graph.vertex_count(); ++u)
      surface.graph.for_each_out_edge(u, [&](std::uint32_t v, std::uint32_t) {
        if (block(u) == block(v)) parts.unite(u, v);
      });
    std::map<std::uint32_t, std::uint32_t> cluster_of_part;
    std::set<std::uint32_t> clusters;
    for (std::uint32_t v = 0; v < surface.graph.vertex_count(); ++v) {
      const auto [at, is_new] =
          cluster_of_part.try_emplace(parts.find(v), tier.cluster_of_vertex[v]);
      ASSERT_EQ(at->second, tier.cluster_of_vertex[v]);
      EXPECT_EQ(clusters.insert(at->second).second, is_new) << "one cluster for two parts";
    }
    EXPECT_EQ(clusters.size(), tier.centers.size());
  }
}

TEST(SurfaceHierarchy, ClustersAreNeighboursWhereAnEdgeOfTheSurfaceJoinsThem) {
  const testing::Prepared p(testing::torus({16, 16, 16}), GeodesicMode::hierarchy);
  const ClusterTier finer = coarser_tier(finest_tier(p.surface), p.surface.graph);
  const ClusterTier tier = coarser_tier(finer, finer.neighbors);
  std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
  for (std::uint32_t u = 0; u < p.surface.graph.vertex_count(); ++u)
    p.surface.graph.for_each_out_edge(u, [&](std::uint32_t v, std::uint32_t) {
      const std::uint32_t a = tier.cluster_of_vertex[u];
      const std::uint32_t b = tier.cluster_of_vertex[v];
      if (a != b) expected.emplace(a, b);
    });
  std::set<std::pair<std::uint32_t, std::uint32_t>> found;
  for (std::uint32_t a = 0; a < tier.centers.size(); ++a)
    tier.neighbors.for_each_out_edge(a, [&](std::uint32_t b, std::uint32_t edge) {
      found.emplace(a, b);
      EXPECT_FLOAT_EQ(tier.neighbors.lengths[edge],
                      static_cast<float>(distance(tier.centers[a], tier.centers[b])));
    });
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace isoloop
