#include "core/z2/bit_column.h"

#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

TEST(BitColumn, HoldsTheRowsFlippedAnOddNumberOfTimes) {
  for (const std::uint32_t bound : {1U, 64U, 65U, 4096U, 4097U, 300'000U}) {
    std::mt19937 random(bound);
    BitColumn column(bound);
    std::set<std::uint32_t> expected;
    for (int step = 0; step < 2000; ++step) {
      const std::uint32_t row = random() % 3 == 0 && !expected.empty()
                                    ? *expected.rbegin()
                                    : static_cast<std::uint32_t>(random() % bound);
      column.flip(row);
      if (!expected.erase(row)) expected.insert(row);
      ASSERT_EQ(column.holds(row), expected.count(row) == 1);
      ASSERT_EQ(column.empty(), expected.empty());
      if (!expected.empty()) {
        ASSERT_EQ(column.youngest(), *expected.rbegin());
      }
    }
    std::vector<std::uint32_t> rows;
    column.drain(rows);
    EXPECT_EQ(rows, std::vector<std::uint32_t>(expected.rbegin(), expected.rend()));
    EXPECT_TRUE(column.empty());
  }
}

}  // namespace
}  // namespace isoloop
