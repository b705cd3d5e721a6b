#include "core/scan/parting.h"

#include <gtest/gtest.h>

namespace isoloop {
namespace {

/// Rows at 0, 1, 2, ... of a volume with so many voxels of each of these values.
std::vector<ScanRow> rows_of(const std::vector<std::int64_t>& voxels) {
  std::vector<ScanRow> rows(voxels.size());
  std::int64_t inside = 0;
  for (std::size_t i = voxels.size(); i-- > 0;) {
    inside += voxels[i];
    rows[i].iso = static_cast<double>(i);
    rows[i].inside_voxels = inside;
  }
  return rows;
}

TEST(Parting, IsBestBetweenTwoHills) {
  const auto rows = rows_of({10, 80, 10, 1, 1, 5, 40, 5});
  const auto shares = parting(rows, 152);
  EXPECT_EQ(shares[0], 0.0) << "no voxel lies below";
  ASSERT_TRUE(otsu_row(shares));
  EXPECT_GE(*otsu_row(shares), 3U);
  EXPECT_LE(*otsu_row(shares), 5U);
  EXPECT_LT(shares[1], 0.7);
}

TEST(Parting, IsTheSameFromBelow) {
  auto rows = rows_of({10, 80, 10, 1, 1, 5, 40, 5});
  const auto above = parting(rows, 152);
  for (ScanRow& row : rows) row.inside_voxels = 152 - row.inside_voxels;
  const auto below = parting(rows, 152);
  for (std::size_t i = 0; i < above.size(); ++i) EXPECT_DOUBLE_EQ(above[i], below[i]);
}

TEST(Parting, OfAMaskIsBestInTheMiddle) {
  EXPECT_EQ(otsu_row(parting(rows_of({50, 0, 0, 0, 0, 0, 0, 0, 9}), 59)),
            std::optional<std::size_t>(4));
}

TEST(Parting, OfOneValueIsNone) {
  EXPECT_EQ(otsu_row(parting(rows_of({7}), 7)), std::nullopt);
  EXPECT_EQ(otsu_row(parting({}, 7)), std::nullopt);
}

TEST(Valley, IsTheDeepestOneBetweenHills) {
  const auto rows = rows_of({5, 9000, 4000, 300, 20, 2, 30, 400, 5000, 900, 20, 1});
  const auto shares = parting(rows, 20'000);
  EXPECT_EQ(valley_row(rows, 20'000, shares, 0.0), std::optional<std::size_t>(5));
  EXPECT_EQ(valley_row(rows, 20'000, shares, 1.1), std::nullopt) << "nowhere a good parting";
  const auto slope = rows_of({900, 600, 500, 400, 200, 100, 50, 20});
  EXPECT_EQ(valley_row(slope, 2770, parting(slope, 2770), 0.0), std::nullopt);
}

}  // namespace
}  // namespace isoloop
