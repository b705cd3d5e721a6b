#include "core/sizes/point_tree.h"

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

double squared(const Vec3& place, const Point& point, const Vec3& scale) {
  double sum = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
    sum += scale[a] * (place[a] - point[a]) * scale[a] * (place[a] - point[a]);
  return sum;
}

/// Points of few coordinates, many of them equally far from a place.
struct Sample {
  std::vector<Point> points;
  Vec3 scale;

  explicit Sample(std::mt19937& random) : scale{1.0, 1.0, 1.0 + random() % 3} {
    const std::uint32_t few = 2 + random() % 30;
    points.resize(1 + random() % 700);
    for (Point& point : points)
      for (float& at : point) at = static_cast<float>(random() % few) / 2.0F;
  }

  std::uint32_t nearest(const Vec3& place) const {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < points.size(); ++i)
      if (squared(place, points[i], scale) < squared(place, points[best], scale)) best = i;
    return best;
  }
};

TEST(PointTree, FindsTheFirstOfTheNearestWhateverTheGuess) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Sample sample(random);
    const PointTree tree(sample.points, sample.scale);
    for (int asked = 0; asked < 20; ++asked) {
      Vec3 place{};
      for (double& at : place) at = static_cast<double>(random() % 80) / 4.0 - 2.0;
      const auto guess = static_cast<std::uint32_t>(random() % sample.points.size());
      ASSERT_EQ(tree.nearest(place, guess), sample.nearest(place));
    }
  }
}

TEST(PointTree, RivalsHoldTheNearestToEveryPlaceNearTheCenter) {
  std::mt19937 random(2);
  std::size_t left_out = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Sample sample(random);
    const PointTree tree(sample.points, sample.scale);
    Vec3 center{};
    for (double& at : center) at = static_cast<double>(random() % 80) / 4.0 - 2.0;
    const Vec3 half{0.5 * (random() % 4), 0.5 * (random() % 4), 0.5 * (random() % 4)};
    std::vector<std::uint32_t> rivals;
    tree.find_rivals(center, half, tree.nearest(center, 0), rivals);
    ASSERT_TRUE(std::is_sorted(rivals.begin(), rivals.end()));
    left_out += sample.points.size() - rivals.size();
    for (int asked = 0; asked < 50; ++asked) {
      Vec3 place = center;
      for (std::size_t a = 0; a < 3; ++a)
        place[a] += half[a] * (static_cast<double>(random() % 9) / 4.0 - 1.0);
      ASSERT_TRUE(std::binary_search(rivals.begin(), rivals.end(), sample.nearest(place)));
    }
  }
  EXPECT_GT(left_out, 10'000U);
}

}  // namespace
}  // namespace isoloop
