#include "volume/shapes/curve_distance.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "volume/shapes/shape_field.h"

namespace isoloop {
namespace {

TEST(CurveDistance, IsThatOfTheNearestSegmentEverywhere) {
  const Index3 dims{37, 20, 29};
  std::mt19937 random(7);
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) {
    const auto coordinate = [&](std::int64_t dim) {
      return static_cast<double>(random() % 1000) * 0.001 * static_cast<double>(dim - 1);
    };
    points.push_back({coordinate(dims[0]), coordinate(dims[1]), coordinate(dims[2])});
  }
  const CurveDistance distance(points, dims);
  for (int n = 0; n < 5000; ++n) {
    const Vec3 p{static_cast<double>(random() % 37), static_cast<double>(random() % 20),
                 static_cast<double>(random() % 29)};
    double least = 1e9;
    for (std::size_t s = 0; s < points.size(); ++s) {
      least =
          std::min(least, squared_segment_distance(p, points[s], points[(s + 1) % points.size()]));
    }
    EXPECT_DOUBLE_EQ(distance(p), std::sqrt(least));
  }
}

TEST(CurveDistance, TakesASinglePointForACurve) {
  const CurveDistance distance({{3.0, 4.0, 0.0}}, {10, 10, 10});
  EXPECT_DOUBLE_EQ(distance({0.0, 0.0, 0.0}), 5.0);
}

}  // namespace
}  // namespace isoloop
