#include "core/surface/surface_order.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/base/disjoint_sets.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

TEST(SurfaceOrder, ListsEveryEdgeOfTheSurfaceOnce) {
  const testing::Prepared prepared(testing::white_noise({8, 8, 8}, 1));
  const SurfaceOrder order = order_surface(prepared.surface);
  const std::set<std::array<std::uint32_t, 2>> edges(order.edges.begin(), order.edges.end());
  EXPECT_EQ(edges.size(), order.edges.size());
  EXPECT_EQ(2 * edges.size(), prepared.surface.graph.lengths.size());
  for (const auto& [a, b, c] : prepared.surface.triangles) {
    const std::uint32_t row = row_between(prepared.surface, order, b, a);
    EXPECT_EQ(order.edges[row], (std::array{std::min(a, b), std::max(a, b)}));
  }
}

TEST(SurfaceOrder, OldestEdgesAreASpanningForest) {
  const testing::Prepared prepared(testing::white_noise({8, 8, 8}, 2));
  const SurfaceOrder order = order_surface(prepared.surface);
  DisjointSets sets(static_cast<std::uint32_t>(prepared.surface.points.size()));
  for (std::uint32_t row = 0; row < order.row_count(); ++row)
    EXPECT_EQ(sets.unite(order.edges[row][0], order.edges[row][1]), row < order.tree);
}

TEST(SurfaceOrder, TwiceTheGenusStaysUnpaired) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const testing::Prepared prepared(testing::white_noise({8, 8, 8}, seed));
    const SurfaceOrder order = order_surface(prepared.surface);
    EXPECT_EQ(order.killed - order.tree, 2 * prepared.surface.genus());
  }
}

TEST(SurfaceOrder, YoungestRowOfEachKilledCycleIsItsOwn) {
  const testing::Prepared prepared(testing::smooth_noise({12, 12, 12}, 4, 1));
  const SurfaceOrder order = order_surface(prepared.surface);
  ASSERT_EQ(order.killed_cycles.size(), order.row_count() - order.killed);
  for (std::size_t i = 0; i < order.killed_cycles.size(); ++i) {
    const auto& cycle = order.killed_cycles[i];
    EXPECT_EQ(*std::max_element(cycle.begin(), cycle.end()), order.killed + i);
  }
}

}  // namespace
}  // namespace isoloop
