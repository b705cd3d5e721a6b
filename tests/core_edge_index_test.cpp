#include <vector>

#include <gtest/gtest.h>

#include "core/edge_index.h"
#include "tests/core_fixture.h"

namespace isoloop {
namespace {

TEST(EdgeIndex, NumbersTheCutEdgesInScanOrder) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const testing::SmallVolume volume = testing::white_noise({9, 5, 7}, seed);
    const Sides sides = classify(volume.view(), testing::zero_level);
    const EdgeIndex edges(sides);
    std::uint32_t next = 0;
    for (std::uint32_t v = 0; v < sides.lattice.vertex_count(); ++v) {
      const auto p = sides.lattice.position(v);
      for (std::uint32_t a = 0; a < 3; ++a) {
        const bool cut = p[a] + 1 < sides.lattice.dims[a] &&
                         sides.inside[v] != sides.inside[v + sides.lattice.stride[a]];
        ASSERT_EQ(edges.is_cut(3 * v + a), cut);
        if (cut) {
          ASSERT_EQ(edges.vertex_on(3 * v + a), next++);
        }
      }
    }
    EXPECT_EQ(edges.count(), next);
  }
}

TEST(EdgeIndex, VisitsEachCutEdgeOnce) {
  const testing::Prepared p(testing::smooth_noise({12, 11, 10}, 1, 1), GeodesicMode::hierarchy);
  std::uint32_t next = 0;
  for (std::uint32_t b = 0; b < p.edges.block_count(); ++b)
    p.edges.visit_block(b, [&](std::uint32_t vertex, std::uint32_t edge) {
      ASSERT_EQ(vertex, next++);
      ASSERT_EQ(p.surface.grid_edges[vertex], edge);
    });
  EXPECT_EQ(next, p.edges.count());
}

}  // namespace
}  // namespace isoloop
