#include "volume/voxels/labels.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

using test::contains;
using test::message_of;

TEST(Labels, BecomeAMask) {
  const Volume map{.values = std::vector<std::int16_t>{0, 3, -1, 7, 3}, .dims = {5, 1, 1}};
  const Volume mask = mask_of_labels(map, {3, -1}, "map");
  EXPECT_EQ(std::get<std::vector<std::uint8_t>>(mask.values),
            (std::vector<std::uint8_t>{0, 1, 1, 0, 1}));
  EXPECT_TRUE(mask.mask);
  EXPECT_EQ(mask.dims, map.dims);
  EXPECT_TRUE(mask.warnings.empty());
}

TEST(Labels, OfARepairedMaskAreThoseOfMostNeighboursOnTheNewSide) {
  // Two rows of three: 3 3 0 and 4 7 0.
  const Volume map{.values = std::vector<std::int16_t>{3, 3, 0, 4, 7, 0}, .dims = {3, 2, 1}};
  const auto after = [&](std::size_t voxel, bool is_inside,
                         const std::vector<std::int64_t>& asked) {
    const SidedVoxel sided{.voxel = voxel, .is_inside = is_inside};
    return labels_of_sided(view(map), std::span(&sided, 1), asked).at(0);
  };
  EXPECT_EQ(after(4, true, {3, 4}), 3) << "two of 3 beside one of 4";
  EXPECT_EQ(after(3, true, {4, 7}), 7) << "its own label does not count";
  EXPECT_EQ(after(1, false, {3}), 0) << "two of 0 beside 4 and 7";
  EXPECT_EQ(after(0, false, {3}), 4) << "4 and 7 have one each: the least";
  EXPECT_EQ(after(2, true, {4, 9}), 4) << "no voxel round it is inside: one that occurs";
  EXPECT_EQ(after(5, false, {0, 3, 7}), 1) << "nor outside: the least that is not asked for";
}

TEST(Labels, SpreadFromTheRimOfWhatIsFilled) {
  // A row of 5, seven voxels of 0, then 9.
  const Volume map{.values = std::vector<std::uint8_t>{5, 0, 0, 0, 0, 0, 0, 0, 9},
                   .dims = {9, 1, 1}};
  std::vector<SidedVoxel> filled;
  for (std::size_t voxel = 1; voxel < 8; ++voxel) filled.push_back({voxel, true});
  EXPECT_EQ(labels_of_sided(view(map), filled, {300, 5, 9}),
            (std::vector<std::int64_t>{5, 5, 5, 5, 9, 9, 9}))
      << "300, which no voxel has, is given to none";
}

TEST(Labels, AreTheWholeNumbersNearestToTheValues) {
  const Volume map{.values = std::vector<float>{0, 2, 1.9999847F, 2.009F, 0.995F},
                   .dims = {5, 1, 1}};
  const Volume mask = mask_of_labels(map, {2}, "map");
  EXPECT_EQ(std::get<std::vector<std::uint8_t>>(mask.values),
            (std::vector<std::uint8_t>{0, 1, 1, 1, 0}));
  ASSERT_EQ(mask.notes.size(), 2U);
  EXPECT_TRUE(contains(mask.notes[1].text, "2 voxels of these labels")) << mask.notes[1].text;
  EXPECT_TRUE(contains(mask.notes[1].text, "0.009")) << mask.notes[1].text;
  EXPECT_TRUE(mask.warnings.empty());
  EXPECT_EQ(mask_of_labels(map, {0}, "map").notes.size(), 1U);
}

TEST(Labels, AreNotTakenFromAVolumeOfOtherValues) {
  std::vector<double> values(2000, 1.0);
  values[7] = 1.5;
  values[8] = 0.25;
  const Volume map{.values = values, .dims = {2000, 1, 1}};
  const Volume mask = mask_of_labels(map, {1}, "map");
  ASSERT_EQ(mask.warnings.size(), 1U);
  EXPECT_TRUE(contains(mask.warnings[0].text, "reason: 2")) << mask.warnings[0].text;
  EXPECT_EQ(std::get<std::vector<std::uint8_t>>(mask.values)[7], 0);
  values[9] = -1e300;
  const std::string message = message_of<InvalidArgument>([&] {
    mask_of_labels({.values = values, .dims = {2000, 1, 1}}, {1}, "map");
  });
  EXPECT_TRUE(contains(message, "3 of 2000 voxels") && contains(message, "1.5, 0.25")) << message;
}

TEST(Labels, OfManyAskedForAreAllTaken) {
  const Volume map{.values = std::vector<std::uint16_t>{5, 4, 3, 2, 1, 0}, .dims = {6, 1, 1}};
  EXPECT_EQ(std::get<std::vector<std::uint8_t>>(mask_of_labels(map, {1, 3, 3, 5}, "m").values),
            (std::vector<std::uint8_t>{1, 0, 1, 0, 1, 0}));
}

TEST(Labels, ThatNoVoxelHasAreNamed) {
  const Volume map{.values = std::vector<std::uint8_t>{0, 3, 7, 3}, .dims = {4, 1, 1}};
  const std::string message = message_of<InvalidArgument>([&] {
    mask_of_labels(map, {4, 5}, "map");
  });
  EXPECT_TRUE(contains(message, "4, 5") && contains(message, "0, 3, 7")) << message;
  EXPECT_TRUE(contains(mask_of_labels(map, {3, 5}, "map").warnings.at(0).text, "label 5"));
}

}  // namespace
}  // namespace isoloop
