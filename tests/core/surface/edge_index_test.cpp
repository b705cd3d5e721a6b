#include "core/surface/edge_index.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

TEST(EdgeIndex, NumbersEachCutEdgeOnceAndEachRowOfThemInOrder) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const testing::SmallVolume volume = testing::white_noise({19, 15, 17}, seed);
    const VoxelSides sides = classify(volume.view(), testing::zero_level);
    const EdgeIndex edges(sides);
    std::vector<bool> taken(edges.count());
    for (std::uint32_t v = 0; v < sides.lattice.vertex_count(); ++v) {
      const auto p = sides.lattice.position(v);
      for (std::uint32_t a = 0; a < 3; ++a) {
        const bool cut = p[a] + 1 < sides.lattice.dims[a] &&
                         sides.inside[v] != sides.inside[v + sides.lattice.stride[a]];
        ASSERT_EQ(edges.is_cut(3 * v + a), cut);
        if (!cut) continue;
        const std::uint32_t number = edges.vertex_on(3 * v + a);
        ASSERT_LT(number, edges.count());
        ASSERT_FALSE(taken[number]);
        taken[number] = true;
        for (std::uint32_t left = v, x = p[0]; x-- > 0;)
          if (edges.is_cut(3 * --left + a)) {
            ASSERT_LT(edges.vertex_on(3 * left + a), number);
          }
      }
    }
    EXPECT_EQ(std::count(taken.begin(), taken.end(), false), 0);
  }
}

TEST(EdgeIndex, NumbersNeighboursOnTheSurfaceCloseToEachOther) {
  const testing::Prepared p(testing::torus({48, 48, 48}), GeodesicMode::hierarchy);
  std::uint32_t near = 0;
  for (std::uint32_t u = 0; u < p.surface.graph.vertex_count(); ++u)
    p.surface.graph.for_each_out_edge(u, [&](std::uint32_t v, std::uint32_t) {
      if (std::max(u, v) - std::min(u, v) <= 64) ++near;
    });
  EXPECT_GT(near, p.surface.graph.lengths.size() * 3 / 4);
}

TEST(EdgeIndex, VisitsEachCutEdgeOnce) {
  const testing::Prepared p(testing::smooth_noise({12, 11, 10}, 1, 1), GeodesicMode::hierarchy);
  std::uint32_t visited = 0;
  for (std::uint32_t b = 0; b < p.edges.block_count(); ++b)
    p.edges.visit_block(b, [&](std::uint32_t vertex, std::uint32_t edge) {
      ++visited;
      ASSERT_EQ(vertex, p.edges.vertex_on(edge));
      ASSERT_EQ(p.surface.grid_edges[vertex], edge);
    });
  EXPECT_EQ(visited, p.edges.count());
}

}  // namespace
}  // namespace isoloop
