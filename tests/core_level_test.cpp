#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "core/level.h"

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

TEST(Level, ProductsStayFiniteForAnyInput) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double most = std::numeric_limits<double>::max();
  for (const double value : {infinity, -infinity, most, -most}) {
    const double level = level_of(value, {-most, InsideRule::above});
    EXPECT_TRUE(std::isfinite(level * level)) << value;
    EXPECT_EQ(level >= 0.0, value >= -most) << value;
  }
}

}  // namespace
}  // namespace isoloop
