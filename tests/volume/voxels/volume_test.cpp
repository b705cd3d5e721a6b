#include "volume/voxels/volume.h"

#include <limits>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

TEST(Volume, ViewKeepsTypeShapeAndValues) {
  const Volume volume{.values = std::vector<std::int16_t>{-1, 2, 3, 4, 5, 6},
                      .dims = {3, 2, 1},
                      .spacing = {0.5, 1.0, 2.0}};
  const auto grid = std::get<GridView<std::int16_t>>(view(volume));
  EXPECT_EQ(grid.dims, volume.dims);
  EXPECT_EQ(grid.spacing, volume.spacing);
  EXPECT_EQ(grid.values.size(), 6U);
  EXPECT_EQ(grid.values[0], -1);
}

TEST(Volume, WorldIsOriginPlusSpacedColumns) {
  Volume volume{.dims = {2, 2, 2}, .spacing = {2.0, 3.0, 4.0}, .origin = {10.0, 20.0, 30.0}};
  EXPECT_EQ(to_world(volume, {1.0, 1.0, 0.5}), (Vec3{12.0, 23.0, 32.0}));
  volume.direction = {Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}};
  EXPECT_EQ(to_world(volume, {1.0, 1.0, 0.5}), (Vec3{7.0, 22.0, 32.0}));
}

TEST(Volume, EveryTypeHasItsNameSizeAndShortName) {
  for (int i = 0; i < 8; ++i) {
    const auto type = static_cast<VoxelType>(i);
    EXPECT_EQ(parse_voxel_type(type_name(type)), type);
  }
  EXPECT_EQ(type_name(VoxelArray{std::vector<float>{}}), "float32");
  EXPECT_EQ(type_name(VoxelArray{std::vector<std::uint16_t>{}}), "uint16");
  EXPECT_EQ(voxel_type(VoxelArray{std::vector<double>{}}), VoxelType::float64);
  EXPECT_EQ(parse_voxel_type("i16"), VoxelType::int16);
  EXPECT_EQ(parse_voxel_type("f32"), VoxelType::float32);
  EXPECT_FALSE(parse_voxel_type("int64"));
  EXPECT_EQ(bytes_per_voxel(VoxelType::uint8), 1U);
  EXPECT_EQ(bytes_per_voxel(VoxelType::int16), 2U);
  EXPECT_EQ(bytes_per_voxel(VoxelType::float64), 8U);
}

TEST(Volume, ValueRangePassesOverNan) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const ValueRange range =
      value_range({.values = std::vector<float>{nan, 3.0F, nan, -2.0F}, .dims = {4, 1, 1}});
  EXPECT_EQ(range.min, -2.0);
  EXPECT_EQ(range.max, 3.0);
  const ValueRange none = value_range({.values = std::vector<float>{nan}, .dims = {1, 1, 1}});
  EXPECT_EQ(none.min, 0.0);
  EXPECT_EQ(none.max, 0.0);
  const ValueRange bytes = value_range({.values = std::vector<std::uint8_t>{7, 255, 9}});
  EXPECT_EQ(bytes.min, 7.0);
  EXPECT_EQ(bytes.max, 255.0);
}

TEST(Volume, AFewDistinctValuesAreListed) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Volume mask{.values = std::vector<float>{nan, 3, 3, -2, nan, 3}, .dims = {6, 1, 1}};
  EXPECT_EQ(value_range(mask).distinct, (std::vector<double>{-2, 3}));
  std::vector<std::int16_t> values;
  for (std::int16_t value = 31; value >= 0; --value) values.insert(values.end(), 3, value);
  const ValueRange few = value_range({.values = values, .dims = {96, 1, 1}});
  ASSERT_EQ(few.distinct.size(), most_distinct);
  EXPECT_EQ(few.distinct.front(), 0);
  EXPECT_EQ(few.distinct.back(), 31);
  values.push_back(-7);
  values.push_back(99);
  const ValueRange many = value_range({.values = values, .dims = {98, 1, 1}});
  EXPECT_TRUE(many.distinct.empty());
  EXPECT_EQ(many.min, -7);
  EXPECT_EQ(many.max, 99);
}

}  // namespace
}  // namespace isoloop
