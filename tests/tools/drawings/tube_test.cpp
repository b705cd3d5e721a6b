#include "tools/drawings/tube.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

std::vector<Vec3> circle(int points, double lift) {
  std::vector<Vec3> polyline;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / points;
    polyline.push_back({10 * std::cos(angle), 10 * std::sin(angle), lift * std::sin(2 * angle)});
  }
  return polyline;
}

double signed_volume(const Tube& tube) {
  double six_fold = 0.0;
  for (const auto& [a, b, c] : tube.triangles) {
    const Vec3& p = tube.points[a];
    const Vec3& q = tube.points[b];
    const Vec3& r = tube.points[c];
    six_fold += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
                p[2] * (q[0] * r[1] - q[1] * r[0]);
  }
  return six_fold / 6.0;
}

TEST(ClosedTube, IsClosedAndOriented) {
  const Tube tube = closed_tube(circle(20, 3.0), 0.25);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
  for (const auto& t : tube.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++directed[{t[i], t[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : directed) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(directed.count({edge.second, edge.first}), 1U);
  }
}

TEST(ClosedTube, HasItsNormalsOutside) {
  const double volume = signed_volume(closed_tube(circle(60, 0.0), 0.25));
  const double hexagon = 1.5 * std::sqrt(3.0) * 0.25 * 0.25;
  EXPECT_NEAR(volume, hexagon * 2.0 * std::numbers::pi * 10.0, 0.02 * volume);
}

TEST(ClosedTube, StaysAtItsRadius) {
  const std::vector<Vec3> polyline = circle(30, 4.0);
  const Tube tube = closed_tube(polyline, 0.25);
  ASSERT_EQ(tube.points.size(), polyline.size() * tube_sides);
  for (std::size_t i = 0; i < tube.points.size(); ++i) {
    const Vec3& centre = polyline[i / tube_sides];
    const Vec3& p = tube.points[i];
    EXPECT_NEAR(std::hypot(p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]), 0.25, 1e-9);
  }
}

TEST(ClosedTube, DoesNotTwistWhereItCloses) {
  const std::vector<Vec3> polyline = circle(40, 6.0);
  const Tube tube = closed_tube(polyline, 0.25);
  for (std::uint32_t side = 0; side < tube_sides; ++side) {
    const Vec3& first = tube.points[side];
    const Vec3& last = tube.points[tube.points.size() - tube_sides + side];
    const Vec3& p = polyline.front();
    const Vec3& q = polyline.back();
    const Vec3 gap{first[0] - p[0] - (last[0] - q[0]), first[1] - p[1] - (last[1] - q[1]),
                   first[2] - p[2] - (last[2] - q[2])};
    EXPECT_LT(std::hypot(gap[0], gap[1], gap[2]), 0.12);
  }
}

TEST(ClosedTube, SurvivesPointsThatCoincideOrTurnBack) {
  const std::vector<Vec3> polyline{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  for (const Vec3& point : closed_tube(polyline, 0.25).points) {
    for (const double x : point) EXPECT_TRUE(std::isfinite(x));
  }
}

TEST(ClosedTube, IsEmptyForFewerThanTwoPoints) {
  EXPECT_TRUE(closed_tube({}, 0.25).points.empty());
  EXPECT_TRUE(closed_tube(std::vector<Vec3>{{1, 2, 3}}, 0.25).triangles.empty());
}

}  // namespace
}  // namespace isoloop
