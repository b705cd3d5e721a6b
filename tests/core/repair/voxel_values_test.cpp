#include "core/repair/voxel_values.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "core/grid/level.h"

namespace isoloop {
namespace {

TEST(VoxelValues, ReadAndWriteTheStoredType) {
  const std::vector<std::uint8_t> stored{1, 200, 3};
  VoxelValues values(GridView<std::uint8_t>{stored, {3, 1, 1}});
  EXPECT_EQ(values.at(1), 200.0);
  values.set(1, 7.0);
  const auto view = std::get<GridView<std::uint8_t>>(values.view());
  EXPECT_EQ(view.values[1], 7);
  EXPECT_EQ(stored[1], 200);
}

TEST(VoxelValues, NearestValuesLieOnTheSideAskedFor) {
  const std::vector<std::uint8_t> bytes{0};
  const std::vector<float> floats{0.0F};
  const VoxelValues small(GridView<std::uint8_t>{bytes, {1, 1, 1}});
  const VoxelValues real(GridView<float>{floats, {1, 1, 1}});
  for (const InsideRule rule : {InsideRule::above, InsideRule::below})
    for (const double iso : {0.5, 1.0, 70.0, 254.5})
      for (const double magnitude : {0.0, 1e-9, 0.4, 3.0, 1e4})
        for (const bool inside : {false, true})
          for (const VoxelValues* values : {&small, &real}) {
            const IsoLevel level{iso, rule};
            const auto value = values->nearest(magnitude, inside, level);
            ASSERT_TRUE(value);
            EXPECT_EQ(level_of(*value, level) >= 0.0, inside)
                << iso << ' ' << magnitude << ' ' << *value;
          }
  EXPECT_EQ(small.nearest(3.0, true, {70.0}), 73.0);
  EXPECT_EQ(small.nearest(3.0, false, {70.0}), 67.0);
  EXPECT_EQ(small.nearest(0.0, false, {70.0}), 69.0);
  EXPECT_EQ(small.nearest(1000.0, true, {70.0}), 255.0);
}

TEST(VoxelValues, NearestValuesOfABandLieAtItsLowerEndUnlessTheTypeHasNoneThere) {
  const std::vector<std::uint8_t> bytes{0};
  const VoxelValues values(GridView<std::uint8_t>{bytes, {1, 1, 1}});
  const IsoLevel band{70.0, InsideRule::above, Topology::trilinear, 80.0};
  EXPECT_EQ(values.nearest(2.0, true, band), 72.0);
  EXPECT_EQ(values.nearest(1000.0, true, band), 75.0);
  EXPECT_EQ(values.nearest(2.0, false, band), 68.0);
  const IsoLevel from_zero{0.0, InsideRule::above, Topology::trilinear, 80.0};
  EXPECT_EQ(values.nearest(2.0, false, from_zero), 82.0);
  const IsoLevel all{0.0, InsideRule::above, Topology::trilinear, 255.0};
  EXPECT_FALSE(values.nearest(1.0, false, all));
}

TEST(VoxelValues, HaveNoValueBeyondTheEndOfTheType) {
  const std::vector<std::uint8_t> bytes{0};
  const VoxelValues values(GridView<std::uint8_t>{bytes, {1, 1, 1}});
  EXPECT_FALSE(values.nearest(1.0, false, {0.0}));
  EXPECT_FALSE(values.nearest(1.0, true, {256.0}));
  EXPECT_FALSE(values.nearest(1.0, false, {255.0, InsideRule::below}));
}

}  // namespace
}  // namespace isoloop
