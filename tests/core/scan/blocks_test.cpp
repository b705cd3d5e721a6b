#include "core/scan/blocks.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

TEST(Blocks, HoldMeansAndAreSmallerAtTheFarBorders) {
  const std::vector<std::uint8_t> voxels{0, 2, 7, 4, 6, 9, 1, 1, 1};
  const Blocks blocks = means_of_blocks(GridView<std::uint8_t>{voxels, {3, 3, 1}}, 2);
  EXPECT_EQ(blocks.dims, (Index3{2, 2, 1}));
  EXPECT_EQ(blocks.values, (std::vector<float>{3, 8, 1, 1}));
}

TEST(Blocks, AreNumbersWhereVoxelsAreInfinite) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  const std::vector<float> voxels{infinite, -infinite};
  EXPECT_EQ(means_of_blocks(GridView<float>{voxels, {2, 1, 1}}, 2).values.front(), 0.0F);
}

}  // namespace
}  // namespace isoloop
