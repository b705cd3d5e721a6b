#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/errors.h"
#include "core/sides.h"
#include "tests/random_volumes.h"

namespace isoloop {
namespace {

constexpr IsoLevel above_half{0.5, InsideRule::above};

GridView<float> view_of(const std::vector<float>& values, const Index3& dims) {
  return {values, dims, {1, 1, 1}};
}

TEST(Sides, TheIsoValueItselfIsInside) {
  const std::vector<float> values{0.5F};
  EXPECT_FALSE(classify(view_of(values, {1, 1, 1}), above_half).empty());
  EXPECT_FALSE(classify(view_of(values, {1, 1, 1}), IsoLevel{0.5, InsideRule::below}).empty());
  EXPECT_TRUE(classify(view_of(values, {1, 1, 1}), IsoLevel{0.51, InsideRule::above}).empty());
}

TEST(Sides, TheBoxIsTheSolidsBoundingBoxAndOneLayer) {
  std::vector<float> values(10 * 8 * 6, 0.0F);
  values[3 + 10 * (2 + 8 * 5)] = 1.0F;
  values[4 + 10 * (4 + 8 * 5)] = 1.0F;
  const Sides sides = classify(view_of(values, {10, 8, 6}), above_half);
  EXPECT_EQ(sides.lattice.first, (Index3{2, 1, 4}));
  EXPECT_EQ(sides.lattice.dims, (std::array<std::uint32_t, 3>{4, 5, 3}));
}

TEST(Sides, NaNIsRefusedWithItsPlace) {
  std::vector<float> values(4 * 3 * 2, 1.0F);
  values[1 + 4 * (2 + 3 * 1)] = std::numeric_limits<float>::quiet_NaN();
  try {
    classify(view_of(values, {4, 3, 2}), above_half);
    FAIL() << "accepted";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("(1, 2, 1)"), std::string::npos) << error.what();
  }
}

TEST(Sides, InfiniteValuesAreVeryLargeOnes) {
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<float> values{inf, -inf, -inf, inf};
  const Sides sides = classify(view_of(values, {2, 2, 1}), above_half);
  EXPECT_EQ(sides.lattice.dims, (std::array<std::uint32_t, 3>{4, 4, 3}));
}

TEST(Sides, ADimensionThatDoesNotFitIsRefused) {
  const std::vector<float> values(7, 1.0F);
  EXPECT_THROW(classify(view_of(values, {2, 2, 2}), above_half), InvalidArgument);
  EXPECT_THROW(classify(view_of(values, {7, 1, 1}), IsoLevel{std::nan("")}), InvalidArgument);
}

TEST(Sides, SwappingTheRuleSwapsTheSides) {
  testing::SmallVolume volume = testing::white_noise({5, 5, 5}, 9);
  const Sides above = classify(volume.view(), IsoLevel{0.0, InsideRule::above});
  for (double& value : volume.values) value = -value;
  const Sides below = classify(volume.view(), IsoLevel{0.0, InsideRule::below});
  EXPECT_EQ(above.inside, below.inside);
  EXPECT_EQ(above.cubes, below.cubes);
}

}  // namespace
}  // namespace isoloop
