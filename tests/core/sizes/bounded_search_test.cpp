#include "core/sizes/bounded_search.h"

#include <algorithm>
#include <map>
#include <vector>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <gtest/gtest.h>

#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

std::vector<float> boost_distances(const EdgeGraph& graph, std::uint32_t source) {
  std::vector<float> distances(graph.vertex_count());
  const auto edge_number = get(boost::edge_index, graph.csr);
  boost::dijkstra_shortest_paths(
      graph.csr, source,
      boost::weight_map(boost::make_iterator_property_map(graph.lengths.begin(), edge_number))
          .distance_map(boost::make_iterator_property_map(distances.begin(),
                                                          get(boost::vertex_index, graph.csr))));
  return distances;
}

TEST(BoundedSearch, SettlesExactlyWhatBoostFindsWithinTheRadius) {
  const testing::Prepared prepared(testing::smooth_noise({14, 14, 14}, 7, 2),
                                   GeodesicMode::hierarchy);
  const EdgeGraph& graph = prepared.surface.graph;
  BoundedSearch search;
  for (std::uint32_t source = 0; source < graph.vertex_count(); source += 97) {
    const std::vector<float> expected = boost_distances(graph, source);
    const double radius = 0.5 * (source % 17);
    std::map<std::uint32_t, float> settled;
    float last = 0.0F;
    search.run(graph, source, radius, [&](std::uint32_t vertex, float distance) {
      EXPECT_TRUE(settled.emplace(vertex, distance).second) << "settled twice";
      EXPECT_GE(distance, last);
      last = distance;
      return true;
    });
    for (std::uint32_t v = 0; v < graph.vertex_count(); ++v) {
      if (expected[v] < radius - 1e-4) {
        EXPECT_NEAR(settled.at(v), expected[v], 1e-4);
      } else if (expected[v] > radius + 1e-4) {
        EXPECT_EQ(settled.count(v), 0U);
      }
    }
  }
}

TEST(BoundedSearch, StopsWhenToldTo) {
  const testing::Prepared prepared(testing::torus({16, 16, 16}), GeodesicMode::hierarchy);
  BoundedSearch search;
  int settled = 0;
  search.run(prepared.surface.graph, 0, 1e9, [&](std::uint32_t, float) { return ++settled < 5; });
  EXPECT_EQ(settled, 5);
}

TEST(BoundedSearch, GoesOnOnlyFromVerticesThatLeadOn) {
  const testing::Prepared prepared(testing::torus({16, 16, 16}), GeodesicMode::hierarchy);
  const EdgeGraph& graph = prepared.surface.graph;
  BoundedSearch search;
  std::vector<std::uint32_t> settled;
  const auto settle = [&](std::uint32_t vertex, float) {
    settled.push_back(vertex);
    return true;
  };
  search.run(graph, 7, 1e9, settle, [](std::uint32_t vertex, float) { return vertex == 7; });
  std::vector<std::uint32_t> expected{7};
  graph.for_each_out_edge(7, [&](std::uint32_t next, std::uint32_t) { expected.push_back(next); });
  std::sort(settled.begin(), settled.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(settled, expected);
}

}  // namespace
}  // namespace isoloop
