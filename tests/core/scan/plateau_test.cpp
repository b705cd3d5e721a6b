#include "core/scan/plateau.h"

#include <gtest/gtest.h>

namespace isoloop {
namespace {

ScanRow row(double iso, std::int64_t b1, std::int64_t voxels) {
  return {iso, {1, b1, 0}, 2 - 2 * b1, b1, voxels};
}

TEST(Plateaus, AreRunsOfEqualNumbers) {
  const std::vector<ScanRow> rows{row(1, 0, 1000), row(2, 3, 900), row(3, 3, 800), row(5, 3, 700),
                                  row(6, 4, 600),  row(7, 0, 1),   row(99, 0, 1)};
  const auto plateaus = find_plateaus(rows, 10'000);
  ASSERT_EQ(plateaus.size(), 4U);
  EXPECT_EQ(plateaus[1].first, 1U);
  EXPECT_EQ(plateaus[1].last, 3U);
  EXPECT_EQ(plateaus[1].width, 3.0);
  EXPECT_TRUE(plateaus[1].meaningful);
  EXPECT_FALSE(plateaus[0].meaningful) << "one value";
  EXPECT_FALSE(plateaus[3].meaningful) << "one voxel of 10 000";
  EXPECT_EQ(proposed_row(rows, plateaus), std::optional<std::size_t>(2));
}

TEST(Plateaus, OfNothingProposeNothing) {
  const std::vector<ScanRow> rows{row(1, 0, 10'000), row(2, 0, 10'000)};
  EXPECT_EQ(proposed_row(rows, find_plateaus(rows, 10'000)), std::nullopt);
  EXPECT_TRUE(find_plateaus({}, 10).empty());
}

}  // namespace
}  // namespace isoloop
