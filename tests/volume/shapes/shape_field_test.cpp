#include "volume/shapes/shape_field.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

TEST(ShapeField, DistancesAreNegativeInsideAndExactOutside) {
  EXPECT_DOUBLE_EQ(ball_distance({3, 4, 0}, {0, 0, 0}, 2), 3.0);
  EXPECT_DOUBLE_EQ(ball_distance({1, 1, 1}, {1, 1, 1}, 2), -2.0);
  EXPECT_DOUBLE_EQ(ring_distance({0, 0, 3}, {0, 0, 0}, 2, 4, 1), 4.0);
  EXPECT_DOUBLE_EQ(ring_distance({0, 4, 0}, {0, 0, 0}, 0, 4, 1), -1.0);
  EXPECT_DOUBLE_EQ(rod_distance({5, 2, 0}, {0, 0, 0}, {9, 0, 0}, 0.5), 1.5);
  EXPECT_DOUBLE_EQ(rod_distance({12, 4, 0}, {0, 0, 0}, {9, 0, 0}, 0.5), 4.5);
  EXPECT_DOUBLE_EQ(box_distance({2, 1, 1}, {0, 0, 0}, {4, 2, 2}, 0), -1.0);
  EXPECT_DOUBLE_EQ(box_distance({7, 6, 1}, {0, 0, 0}, {4, 2, 2}, 0), 5.0);
}

TEST(ShapeField, RoundingTakesOffEdgesAndLeavesFaces) {
  EXPECT_DOUBLE_EQ(box_distance({5, 1, 1}, {0, 0, 0}, {4, 2, 2}, 0.5), 1.0);
  EXPECT_GT(box_distance({4, 2, 2}, {0, 0, 0}, {4, 2, 2}, 0.5), 0.1);
}

TEST(ShapeField, DimensionsHoldTheSolidAndItsMargin) {
  for (std::int64_t size = 16; size < 400; ++size) {
    const double extent = shape_extent(size);
    EXPECT_EQ(shape_dims({extent, extent, extent})[1], size);
  }
}

TEST(ShapeField, SamplesInTheOrderOfTheVoxels) {
  const Volume volume = sample_distance(
      {4, 3, 2}, 0, "f", [](const Vec3& p) { return p[0] + 10.0 * p[1] + 100.0 * p[2]; });
  const auto& values = std::get<std::vector<float>>(volume.values);
  ASSERT_EQ(values.size(), 24U);
  EXPECT_EQ(values[3 + 4 * (2 + 3 * 1)], 123.0F);
  EXPECT_EQ(values[1], 1.0F);
  EXPECT_THROW(sample_distance({0, 3, 2}, 0, "f", [](const Vec3&) { return 0.0; }),
               InvalidArgument);
}

}  // namespace
}  // namespace isoloop
