#include "core/grid/level.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

constexpr IsoLevel above_70{70.0, InsideRule::above};
constexpr IsoLevel below_70{70.0, InsideRule::below};

TEST(Level, IsNonNegativeExactlyInside) {
  EXPECT_EQ(level_of(std::uint8_t{71}, above_70), 1.0);
  EXPECT_EQ(level_of(std::uint8_t{69}, above_70), -1.0);
  EXPECT_EQ(level_of(std::uint8_t{71}, below_70), -1.0);
  EXPECT_EQ(level_of(std::uint8_t{69}, below_70), 1.0);
}

TEST(Level, IsZeroAtTheIsoValueUnderBothRules) {
  EXPECT_GE(level_of(70.0F, above_70), 0.0);
  EXPECT_GE(level_of(70.0F, below_70), 0.0);
}

TEST(Level, TellsNeighboursApartInEveryType) {
  const double next = std::nextafter(70.0, 71.0);
  EXPECT_GT(level_of(next, above_70), 0.0);
  EXPECT_LT(level_of(next, below_70), 0.0);
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_LT(level_of(-least, {0.0, InsideRule::above}), 0.0);
  const std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(level_of(most - 1, {static_cast<double>(most), InsideRule::above}), -1.0);
}

TEST(Level, BetweenTwoValuesItIsTheDistanceToTheNearer) {
  const IsoLevel band{70.0, InsideRule::above, Topology::trilinear, 80.0};
  EXPECT_EQ(level_of(std::uint8_t{69}, band), -1.0);
  EXPECT_EQ(level_of(std::uint8_t{70}, band), 0.0);
  EXPECT_EQ(level_of(std::uint8_t{72}, band), 2.0);
  EXPECT_EQ(level_of(std::uint8_t{79}, band), 1.0);
  EXPECT_EQ(level_of(std::uint8_t{80}, band), 0.0);
  EXPECT_EQ(level_of(std::uint8_t{83}, band), -3.0);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_LT(level_of(infinity, band), 0.0);
  EXPECT_LT(level_of(-infinity, band), 0.0);
}

TEST(Level, TheInsideIsWhereItIsNotNegative) {
  const double infinity = std::numeric_limits<double>::infinity();
  const IsoLevel band{70.0, InsideRule::above, Topology::trilinear, 80.0};
  for (const IsoLevel& level : {above_70, below_70, band})
    for (const double value : {-infinity, 0.0, std::nextafter(70.0, 0.0), 70.0, 75.0, 80.0,
                               std::nextafter(80.0, 90.0), infinity})
      EXPECT_EQ(inside_values(level).hold(value), level_of(value, level) >= 0.0) << value;
}

TEST(Level, IsFiniteForAnyInput) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double most = std::numeric_limits<double>::max();
  for (const double value : {infinity, -infinity, most, -most}) {
    const double level = level_of(value, {-most, InsideRule::above});
    EXPECT_TRUE(std::isfinite(level)) << value;
    EXPECT_EQ(level >= 0.0, value >= -most) << value;
  }
}

}  // namespace
}  // namespace isoloop
