#include "tools/words/number_text.h"

#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(ShortestText, ReadsBackAsTheSameNumber) {
  for (const double value : {0.1, 1.0 / 3.0, 1e300, -5e-324, 123456789.0}) {
    EXPECT_EQ(std::strtod(shortest_text(value).c_str(), nullptr), value);
  }
  EXPECT_EQ(shortest_text(70.0), "70");
}

TEST(ShortestText, NamesWhatIsNoNumber) {
  EXPECT_EQ(shortest_text(infinity), "inf");
  EXPECT_EQ(shortest_text(-infinity), "-inf");
  EXPECT_EQ(shortest_text(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(shortest_text(-0.0), "0");
}

TEST(FixedText, KeepsItsDigits) {
  EXPECT_EQ(fixed_text(2.0, 2), "2.00");
  EXPECT_EQ(fixed_text(1e300, 0).size(), 301U);
  EXPECT_EQ(fixed_text(infinity, 2), "inf");
}

TEST(FixedText, HasNoNegativeZero) {
  EXPECT_EQ(fixed_text(-0.001, 2), "0.00");
  EXPECT_EQ(fixed_text(-0.01, 2), "-0.01");
}

TEST(LengthDecimals, FollowTheSmallestVoxelEdge) {
  EXPECT_EQ(length_decimals({1, 1, 1}), 2);
  EXPECT_EQ(length_decimals({0.5, 0.1, 2}), 3);
  EXPECT_EQ(length_decimals({0.001, 1, 1}), 5);
  EXPECT_EQ(length_decimals({1000, 1000, 1000}), 0);
  EXPECT_EQ(length_decimals({0, 0, 0}), 2);
}

TEST(Counted, AgreesWithTheNumber) {
  EXPECT_EQ(counted(1, "loop", "loops"), "1 loop");
  EXPECT_EQ(counted(0, "loop", "loops"), "0 loops");
}

}  // namespace
}  // namespace isoloop
