#include "core/scan/plateau.h"

#include <gtest/gtest.h>

namespace isoloop {
namespace {

ScanRow row(double iso, std::int64_t b1, std::int64_t voxels) {
  return {iso, {1, b1, 0}, 2 - 2 * b1, b1, voxels, {1, b1, 0}};
}

const std::vector<double>& full_parting() {
  static const std::vector<double> shares(10, 1.0);
  return shares;
}

TEST(Plateaus, AreRunsOfEqualNumbers) {
  const std::vector<ScanRow> rows{row(1, 0, 1000), row(2, 3, 900), row(3, 3, 800), row(5, 3, 700),
                                  row(6, 4, 600),  row(7, 0, 1),   row(99, 0, 1)};
  const auto plateaus = find_plateaus(rows, 10'000, full_parting());
  ASSERT_EQ(plateaus.size(), 4U);
  EXPECT_EQ(plateaus[1].first, 1U);
  EXPECT_EQ(plateaus[1].last, 3U);
  EXPECT_EQ(plateaus[1].width, 3.0);
  EXPECT_EQ(plateaus[1].voxels, 200);
  EXPECT_TRUE(plateaus[1].meaningful);
  EXPECT_FALSE(plateaus[0].meaningful) << "one value";
  EXPECT_FALSE(plateaus[3].meaningful) << "one voxel of 10 000";
  const std::vector<ScanRow> to_the_end{row(0, 0, 10'000), row(1, 0, 900), row(2, 0, 300)};
  EXPECT_EQ(find_plateaus(to_the_end, 10'000, full_parting()).size(), 2U) << "everything";
  EXPECT_TRUE(find_plateaus(to_the_end, 10'000, full_parting())[1].meaningful);
  EXPECT_EQ(middle_row(rows, plateaus[1]), 2U);
}

TEST(Plateaus, OfWhatHardlyChangesMeanNothing) {
  std::vector<ScanRow> rows{row(0, 1, 9000), row(1, 2, 1000), row(2, 2, 900), row(99, 0, 100)};
  EXPECT_FALSE(find_plateaus(rows, 10'000, full_parting())[1].meaningful) << "a tenth";
  rows[2].inside_voxels = 800;
  EXPECT_TRUE(find_plateaus(rows, 10'000, full_parting())[1].meaningful) << "a fifth";
  EXPECT_FALSE(find_plateaus(rows, 10'000, std::vector<double>(4, 0.6))[1].meaningful)
      << "Otsu's value parts the voxels much better";
  rows[2] = row(30, 2, 999);
  EXPECT_TRUE(find_plateaus(rows, 10'000, full_parting())[1].meaningful) << "of the iso values";
}

TEST(Plateaus, AreNotBrokenByOneRowWhereTheyAreMended) {
  const std::vector<ScanRow> rows{row(0, 1, 900), row(1, 1, 800), row(2, 2, 700),
                                  row(3, 1, 600), row(4, 3, 500), row(5, 3, 400)};
  EXPECT_EQ(find_plateaus(rows, 1000, full_parting()).size(), 4U);
  const auto mended = find_plateaus(rows, 1000, full_parting(), true);
  ASSERT_EQ(mended.size(), 2U);
  EXPECT_EQ(mended[0].last, 3U);
}

TEST(Plateaus, AreStablestWhereMostVoxelsChangeSides) {
  const std::vector<ScanRow> rows{row(0, 1, 900),  row(9, 1, 800),  row(10, 2, 700),
                                  row(11, 2, 300), row(12, 3, 200), row(30, 3, 150)};
  EXPECT_EQ(stablest_plateaus(find_plateaus(rows, 1000, full_parting())),
            (std::vector<std::size_t>{1, 0, 2}));
}

TEST(Plateaus, OfNothingAreNone) {
  EXPECT_TRUE(find_plateaus({}, 10, {}).empty());
  EXPECT_TRUE(stablest_plateaus({}).empty());
}

}  // namespace
}  // namespace isoloop
