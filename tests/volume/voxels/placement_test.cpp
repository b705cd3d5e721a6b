#include "volume/voxels/placement.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

using test::contains;
using test::message_of;

Volume placed(const Placement& placement, const std::optional<Vec3>& spacing = std::nullopt) {
  Volume volume;
  volume.dims = {4, 5, 6};
  place(volume, placement, spacing, "file");
  return volume;
}

TEST(Placement, BecomesSpacingDirectionAndOrigin) {
  const Placement placement{.columns = {Vec3{0, 2, 0}, Vec3{-3, 0, 0}, Vec3{0, 0, 4}},
                            .origin = {7, 8, 9},
                            .frame = Frame::ras};
  const Volume volume = placed(placement);
  EXPECT_EQ(volume.spacing, (Vec3{2, 3, 4}));
  EXPECT_EQ(volume.frame, Frame::ras);
  for (const Vec3& index : {Vec3{0, 0, 0}, Vec3{1, 2, 3}, Vec3{3, 4, 5}}) {
    EXPECT_LT(distance(to_world(volume, index), to_world(placement, index)), 1e-12);
  }
}

TEST(Placement, LengthsOfSixDigitsSurviveFloat32) {
  const double rounded = static_cast<double>(0.0607F);
  const Volume volume =
      placed({.columns = {Vec3{rounded, 0, 0}, Vec3{0, 1.00000005, 0}, Vec3{0, 0, 0.123456789}}});
  EXPECT_EQ(volume.spacing, (Vec3{0.0607, 1.0, 0.123456789}));
}

TEST(Placement, ASpacingOfTheCallersReplacesAll) {
  const Placement bad{.columns = {Vec3{0, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 0, 1}},
                      .origin = {1, 2, 3},
                      .frame = Frame::lps};
  EXPECT_THROW(placed(bad), InvalidInput);
  const Volume volume = placed(bad, Vec3{1, 2, 3});
  EXPECT_EQ(volume.spacing, (Vec3{1, 2, 3}));
  EXPECT_EQ(volume.origin, (Vec3{0, 0, 0}));
  EXPECT_EQ(volume.frame, Frame::index);
}

TEST(Placement, ALittleShearIsRoundingAndMoreIsRefused) {
  const auto leaning = [](double by) {
    return Placement{.columns = {Vec3{1, 0, 0}, Vec3{by, 1, 0}, Vec3{0, 0, 1}}};
  };
  EXPECT_NO_THROW(placed(leaning(0.0009)));
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { placed(leaning(0.1)); }), "84.2894"));
}

TEST(Placement, TurnsBetweenRasAndLpsAndBack) {
  const Placement placement{.columns = {Vec3{2, 0, 0}, Vec3{0, 0, 3}, Vec3{0, -4, 0}},
                            .origin = {7, 8, 9},
                            .frame = Frame::ras};
  Volume volume = placed(placement);
  turn_frame(volume, Frame::lps, "file");
  EXPECT_EQ(volume.frame, Frame::lps);
  const Vec3 here = to_world(volume, {1, 2, 3});
  const Vec3 there = to_world(placement, {1, 2, 3});
  EXPECT_LT(distance(here, {-there[0], -there[1], there[2]}), 1e-12);
  turn_frame(volume, Frame::ras, "file");
  EXPECT_LT(distance(to_world(volume, {1, 2, 3}), there), 1e-12);
  Volume raw;
  EXPECT_THROW(turn_frame(raw, Frame::ras, "file"), InvalidArgument);
}

TEST(Placement, LargestDistanceIsThatOfTheFarthestCorner) {
  const Placement one;
  const Placement other{.columns = {Vec3{1, 0, 0}, Vec3{0, 2, 0}, Vec3{0, 0, 1}}};
  EXPECT_EQ(largest_distance(one, other, {4, 5, 6}), 4.0);
}

}  // namespace
}  // namespace isoloop
