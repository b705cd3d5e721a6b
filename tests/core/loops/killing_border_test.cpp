#include "core/loops/killing_border.h"

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using Edge = std::array<std::uint32_t, 2>;

std::multiset<Edge> edges_of(const std::vector<Curve>& curves) {
  std::multiset<Edge> edges;
  for (const Curve& curve : curves)
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const std::uint32_t a = curve[i];
      const std::uint32_t b = curve[(i + 1) % curve.size()];
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  return edges;
}

TEST(KillingBorder, CurvesUseEveryEdgeOnceAndRepeatNoVertex) {
  std::mt19937 random(5);
  for (int round = 0; round < 100; ++round) {
    // Sums of triangles in a complete graph: every degree is even.
    std::set<Edge> sum;
    for (int t = 0; t < 6; ++t) {
      std::set<std::uint32_t> corners;
      while (corners.size() < 3) corners.insert(random() % 7);
      const std::vector<std::uint32_t> c(corners.begin(), corners.end());
      for (const Edge& edge : {Edge{c[0], c[1]}, Edge{c[1], c[2]}, Edge{c[0], c[2]}})
        if (!sum.insert(edge).second) sum.erase(edge);
    }
    const std::vector<Edge> edges(sum.begin(), sum.end());
    const std::vector<Curve> curves = closed_curves(edges);
    EXPECT_EQ(edges_of(curves), std::multiset<Edge>(sum.begin(), sum.end()));
    for (const Curve& curve : curves)
      EXPECT_EQ(std::set<std::uint32_t>(curve.begin(), curve.end()).size(), curve.size());
  }
}

TEST(KillingBorder, IsEvenAtEveryVertexAndOnM) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const testing::Prepared p(testing::white_noise({7, 7, 7}, seed), GeodesicMode::hierarchy);
    for (const Side side : {Side::inside, Side::outside}) {
      const DualPass pass = p.pass_on(side);
      const KillingBorders borders = killing_borders(p.complex(side), pass);
      for (std::uint32_t i = 0; i < pass.killing.size(); ++i) {
        ASSERT_FALSE(borders.of(i).empty());
        std::map<std::uint32_t, int> degree;
        for (const Edge& edge : borders.of(i))
          for (const std::uint32_t v : edge) ++degree[v];
        for (const auto& [vertex, count] : degree) EXPECT_EQ(count % 2, 0);
      }
    }
  }
}

}  // namespace
}  // namespace isoloop
