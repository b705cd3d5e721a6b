#include "core/curves/geodesic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using VertexSet = std::set<std::uint32_t>;

VertexSet support(const SurfacePoint& point) { return {point.edge[0], point.edge[1]}; }

VertexSet merged(const VertexSet& a, const VertexSet& b) {
  VertexSet both = a;
  both.insert(b.begin(), b.end());
  return both;
}

Vec3 scaled(const Surface& surface, const SurfacePoint& point) {
  Vec3 position = index_point(surface, point);
  for (std::size_t a = 0; a < 3; ++a) position[a] *= surface.spacing[a];
  return position;
}

double angle_at(const Vec3& corner, const Vec3& p, const Vec3& q) {
  const double a = distance(corner, p);
  const double b = distance(corner, q);
  const double c = distance(p, q);
  return std::acos(std::clamp((a * a + b * b - c * c) / (2 * a * b), -1.0, 1.0));
}

/// Angle from the point before a vertex to the point behind it, over the triangles on either side.
std::array<double, 2> angles_beside(const Surface& surface, const TriangleFans& fans,
                                    const SurfacePoint& before, std::uint32_t vertex,
                                    const SurfacePoint& behind) {
  // The fan of the vertex, anticlockwise, as angles from its first edge.
  const auto first =
      std::find_if(surface.triangles.begin(), surface.triangles.end(),
                   [&](const auto& t) { return std::find(t.begin(), t.end(), vertex) != t.end(); });
  const auto at =
      static_cast<std::size_t>(std::find(first->begin(), first->end(), vertex) - first->begin());
  std::uint32_t rim = (*first)[(at + 1) % 3];
  const std::uint32_t start = rim;
  const Vec3 corner = scaled_point(surface, vertex);
  double turned = 0.0;
  std::map<const SurfacePoint*, double> direction;
  do {
    const std::uint32_t next = fans.apex(vertex, rim);
    for (const SurfacePoint* point : {&before, &behind}) {
      const VertexSet ends = support(*point);
      const bool here = std::all_of(ends.begin(), ends.end(), [&](std::uint32_t v) {
        return v == rim || v == next || v == vertex;
      });
      if (here) {
        const Vec3 place = scaled(surface, *point);
        direction[point] = turned + angle_at(corner, scaled_point(surface, rim), place);
      }
    }
    turned += angle_at(corner, scaled_point(surface, rim), scaled_point(surface, next));
    rim = next;
  } while (rim != start);
  const double between = std::abs(direction.at(&before) - direction.at(&behind));
  return {between, turned - between};
}

/// How much shorter the way from one point to the next but one gets when the point between moves
/// along its edge.
double gain_of_moving(const Surface& surface, const SurfacePoint& before, SurfacePoint point,
                      const SurfacePoint& behind) {
  const auto length = [&] {
    return distance(scaled(surface, before), scaled(surface, point)) +
           distance(scaled(surface, point), scaled(surface, behind));
  };
  const double now = length();
  const double at = point.at;
  double gain = 0.0;
  for (const double step : {-1e-3, 1e-3}) {
    point.at = std::clamp(at + step, 0.0, 1.0);
    gain = std::max(gain, now - length());
  }
  return gain;
}

/// Calls check(surface, classes, fans, loop curve) for each curve of the loops of many volumes.
template <class Check>
void for_each_curve(const Check& check) {
  std::vector<testing::SmallVolume> volumes{testing::torus({24, 24, 24}),
                                            testing::torus({30, 31, 29}, 0.3, 0.08),
                                            testing::linked_tori({28, 28, 28})};
  for (std::uint32_t seed = 0; seed < 30; ++seed)
    volumes.push_back(testing::smooth_noise({16, 17, 15}, seed, 1 + static_cast<int>(seed) % 2));
  for (std::uint32_t seed = 0; seed < 30; ++seed)
    volumes.push_back(testing::white_noise({7, 6, 7}, seed));
  for (const testing::SmallVolume& volume : volumes) {
    const Analysis analysis = analyze(volume.view(), testing::zero_level);
    const TriangleFans fans(analysis.surface);
    for (const Loop& loop : analysis.loops)
      for (const Curve& curve : loop.curves) check(analysis.surface, fans, curve);
  }
}

TEST(Geodesic, IsNoLongerThanItsCurve) {
  int straightened = 0;
  for_each_curve([&](const Surface& surface, const TriangleFans& fans, const Curve& curve) {
    Geodesic along;
    for (const std::uint32_t vertex : curve) along.push_back({{vertex, vertex}, 0.0});
    const Geodesic geodesic = closed_geodesic(surface, fans, curve);
    EXPECT_LE(length_of(surface, geodesic), length_of(surface, along));
    straightened += length_of(surface, geodesic) < 0.999 * length_of(surface, along) ? 1 : 0;
  });
  EXPECT_GT(straightened, 300);
}

TEST(Geodesic, RunsFromTriangleToTriangle) {
  for_each_curve([](const Surface& surface, const TriangleFans& fans, const Curve& curve) {
    const Geodesic geodesic = closed_geodesic(surface, fans, curve);
    for (std::size_t i = 0; i < geodesic.size(); ++i) {
      const VertexSet needed =
          merged(support(geodesic[i]), support(geodesic[(i + 1) % geodesic.size()]));
      const bool found =
          std::any_of(surface.triangles.begin(), surface.triangles.end(), [&](const auto& t) {
            return std::all_of(needed.begin(), needed.end(), [&](std::uint32_t v) {
              return std::find(t.begin(), t.end(), v) != t.end();
            });
          });
      ASSERT_TRUE(found) << i;
    }
  });
}

TEST(Geodesic, GetsNoShorterByASmallMovement) {
  for_each_curve([](const Surface& surface, const TriangleFans& fans, const Curve& curve) {
    const Geodesic geodesic = closed_geodesic(surface, fans, curve);
    for (std::size_t i = 0; i < geodesic.size(); ++i) {
      const SurfacePoint& before = geodesic[(i + geodesic.size() - 1) % geodesic.size()];
      const SurfacePoint& point = geodesic[i];
      const SurfacePoint& behind = geodesic[(i + 1) % geodesic.size()];
      if (point.edge[0] != point.edge[1]) {
        EXPECT_LT(gain_of_moving(surface, before, point, behind), 1e-5) << i;
        continue;
      }
      for (const double angle : angles_beside(surface, fans, before, point.edge[0], behind))
        EXPECT_GT(angle, std::numbers::pi - 1e-3) << i;
    }
  });
}

TEST(Geodesic, OfACurveThatBoundsATriangleIsTheCurve) {
  const testing::Prepared prepared(testing::torus({20, 20, 20}));
  const TriangleFans fans(prepared.surface);
  const auto& corners = prepared.surface.triangles[7];
  const Curve curve{corners.begin(), corners.end()};
  const Geodesic geodesic = closed_geodesic(prepared.surface, fans, curve);
  EXPECT_EQ(pushed_to_edges(geodesic), curve);
}

TEST(Geodesic, IsPushedToTheNearerEndsOfItsEdges) {
  EXPECT_EQ(pushed_to_edges({{{1, 2}, 0.4}, {{1, 3}, 0.2}, {{5, 3}, 0.7}, {{4, 4}, 0.0}}),
            (Curve{1, 3, 4}));
}

}  // namespace
}  // namespace isoloop
