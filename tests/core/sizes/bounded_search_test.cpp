#include "core/sizes/bounded_search.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/sizes/surface_hierarchy.h"
#include "tests/oracles/shortest_paths.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// Every `step`-th vertex but `source`.
std::vector<Goal> some_goals(std::uint32_t count, std::uint32_t step, std::uint32_t source) {
  std::vector<Goal> goals;
  for (std::uint32_t v = source % step; v < count; v += step)
    if (v != source) goals.push_back({v});
  return goals;
}

TEST(BoundedSearch, FindsToTheBitWhatBoostFindsWithinTheRadius) {
  const testing::Prepared prepared(testing::smooth_noise({14, 14, 14}, 7, 2),
                                   GeodesicMode::hierarchy);
  const EdgeGraph& graph = prepared.surface.graph;
  const std::vector<Vec3> points = finest_tier(prepared.surface).centers;
  std::size_t found = 0;
  for (const double bucket : {0.02, 0.5, 30.0})
    for (std::uint32_t turn = 0; turn < 20; ++turn) {
      const double radius = turn == 19 ? infinite : 0.5 * turn + 0.25;
      BoundedSearch search(graph, points, radius, bucket);
      for (std::uint32_t source = turn; source < graph.vertex_count(); source += 497) {
        const std::vector<float> expected = testing::boost_distances(graph, source);
        // Some are few enough to be told apart.
        std::vector<Goal> goals = some_goals(graph.vertex_count(), turn % 2 ? 11 : 997, source);
        search.run(source, goals);
        for (const Goal& goal : goals) {
          const bool is_near = expected[goal.vertex] <= static_cast<float>(radius);
          EXPECT_EQ(goal.length, is_near ? expected[goal.vertex] : infinite);
          found += is_near ? 1 : 0;
        }
      }
    }
  EXPECT_GT(found, 1000U);
}

TEST(BoundedSearch, ForgetsTheSearchBefore) {
  const testing::Prepared prepared(testing::torus({16, 16, 16}), GeodesicMode::hierarchy);
  const EdgeGraph& graph = prepared.surface.graph;
  const std::vector<Vec3> points = finest_tier(prepared.surface).centers;
  BoundedSearch search(graph, points, 5.0, 0.5);
  for (std::uint32_t source = 0; source < graph.vertex_count(); source += 31) {
    std::vector<Goal> goals = some_goals(graph.vertex_count(), 13, source);
    std::vector<Goal> alone = goals;
    search.run(source, goals);
    BoundedSearch(graph, points, 5.0, 0.5).run(source, alone);
    for (std::size_t i = 0; i < goals.size(); ++i) EXPECT_EQ(goals[i].length, alone[i].length);
  }
}

}  // namespace
}  // namespace isoloop
