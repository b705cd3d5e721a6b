#include <gtest/gtest.h>

#include "core/errors.h"
#include "tests/volume_test_files.h"
#include "volume/labels.h"

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

TEST(Labels, AreFoundInFloatVolumesToo) {
  const Volume map{.values = std::vector<float>{0, 2, 2.5F}, .dims = {3, 1, 1}};
  EXPECT_EQ(std::get<std::vector<std::uint8_t>>(mask_of_labels(map, {2}, "map").values),
            (std::vector<std::uint8_t>{0, 1, 0}));
}

TEST(Labels, ThatNoVoxelHasAreNamed) {
  const Volume map{.values = std::vector<std::uint8_t>{0, 3, 7, 3}, .dims = {4, 1, 1}};
  const std::string message = message_of<InvalidArgument>([&] {
    mask_of_labels(map, {4, 5}, "map");
  });
  EXPECT_TRUE(contains(message, "4, 5") && contains(message, "0, 3, 7")) << message;
  EXPECT_TRUE(contains(mask_of_labels(map, {3, 5}, "map").warnings.at(0), "label 5"));
}

}  // namespace
}  // namespace isoloop
