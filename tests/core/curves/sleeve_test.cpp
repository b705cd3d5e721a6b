#include "core/curves/sleeve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/curves/triangle_fans.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

/// A random walk across triangles that closes up: out and, by other edges or the same, back.
/// Empty where it does not within `most` steps.
std::vector<Portal> random_sleeve(const Surface& surface, const TriangleFans& fans,
                                  std::mt19937& random, std::size_t most) {
  const auto& [a, b, c] = surface.triangles[random() % surface.triangles.size()];
  std::vector<Portal> portals{{a, b, 0.5}};
  while (portals.size() < most) {
    Portal next = portals.back();
    const std::uint32_t apex = fans.apex(next.left, next.right);
    (random() % 2 == 0 ? next.left : next.right) = apex;
    next.at = static_cast<double>(random() % 1001) / 1000.0;
    if (next.left == a && next.right == b) return portals;
    portals.push_back(next);
  }
  return {};
}

/// The least length of a path whose points, but for the first, are among `steps` + 1 on each
/// portal.
double least_on_steps(const Surface& surface, const std::vector<Portal>& portals, int steps) {
  const auto point = [&](std::size_t i, int k) {
    return point_on(surface, {portals[i].left, portals[i].right,
                              static_cast<double>(k) / static_cast<double>(steps)});
  };
  const Vec3 start = point_on(surface, portals[0]);
  std::vector<Vec3> from{start};
  std::vector<double> least{0.0};
  for (std::size_t i = 1; i < portals.size(); ++i) {
    std::vector<Vec3> to;
    std::vector<double> next;
    for (int k = 0; k <= steps; ++k) {
      to.push_back(point(i, k));
      next.push_back(std::numeric_limits<double>::infinity());
      for (std::size_t j = 0; j < from.size(); ++j)
        next.back() = std::min(next.back(), least[j] + distance(from[j], to.back()));
    }
    from = std::move(to);
    least = std::move(next);
  }
  double length = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < from.size(); ++j)
    length = std::min(length, least[j] + distance(from[j], start));
  return length;
}

TEST(Sleeve, TautPathIsTheShortestThroughTheSameEdges) {
  std::mt19937 random(1);
  constexpr int steps = 50;
  int compared = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const testing::Prepared prepared(testing::smooth_noise({9, 9, 9}, seed, 1));
    if (prepared.surface.triangles.empty()) continue;
    const TriangleFans fans(prepared.surface);
    for (int walk = 0; walk < 400; ++walk) {
      std::vector<Portal> portals = random_sleeve(prepared.surface, fans, random, 40);
      if (portals.size() < 3) continue;
      const double before = length_of_path(prepared.surface, portals);
      const Vec3 start = point_on(prepared.surface, portals[0]);
      pull_taut(prepared.surface, portals);
      const double taut = length_of_path(prepared.surface, portals);
      const double least = least_on_steps(prepared.surface, portals, steps);
      EXPECT_EQ(point_on(prepared.surface, portals[0]), start);
      EXPECT_LE(taut, before + 1e-9);
      EXPECT_LE(taut, least + 1e-9) << seed << ' ' << walk << ' ' << portals.size();
      EXPECT_GE(taut, least - 0.02 * static_cast<double>(portals.size()));
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace isoloop
