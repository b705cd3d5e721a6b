#include "volume/files/write.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/volume_test_files.h"
#include "volume/files/read.h"
#include "volume/shapes/shapes.h"

namespace isoloop {
namespace {

using test::contains;
using test::message_of;
using test::TempFolder;

TEST(WriteVolume, RawKeepsEveryValue) {
  const TempFolder folder;
  const Volume torus = make_shape("torus", {.size = 20}).volume;
  const auto path = folder / ("torus_20x20x8_float32.raw");
  write_volume(torus, path);
  EXPECT_EQ(folder.entries(), 1);
  ReadOptions options;
  options.raw.dims = torus.dims;
  EXPECT_EQ(read_volume(path, options).values, torus.values);
}

TEST(WriteVolume, VdbKeepsValuesTransformClassAndName) {
  const TempFolder folder;
  Volume torus = make_shape("torus", {.size = 20}).volume;
  torus.spacing = {0.5, 0.25, 2.0};
  torus.origin = {10.0, -20.0, 30.0};
  torus.direction = {Vec3{0.6, 0.8, 0.0}, Vec3{-0.8, 0.6, 0.0}, Vec3{0.0, 0.0, -1.0}};
  torus.name = "ring";
  write_volume(torus, folder / "torus.vdb");
  const Volume back = read_volume(folder / "torus.vdb");
  EXPECT_EQ(back.name, "ring");
  EXPECT_TRUE(back.level_set);
  EXPECT_EQ(back.frame, Frame::world);
  // One layer of background lies round the written voxels.
  for (std::size_t a = 0; a < 3; ++a) {
    ASSERT_EQ(back.dims[a], torus.dims[a] + 2);
    EXPECT_NEAR(back.spacing[a], torus.spacing[a], 1e-12);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(back.direction[a][c], torus.direction[a][c], 1e-12);
      EXPECT_NEAR(to_world(back, {3, 2, 4})[c], to_world(torus, {2, 1, 3})[c], 1e-9);
    }
  }
  const auto& written = std::get<std::vector<float>>(torus.values);
  const auto& read = std::get<std::vector<float>>(back.values);
  std::int64_t different = 0;
  for (std::int64_t v = 0; v < static_cast<std::int64_t>(written.size()); ++v) {
    const Index3 at{v % torus.dims[0], v / torus.dims[0] % torus.dims[1],
                    v / (torus.dims[0] * torus.dims[1])};
    const std::int64_t w = at[0] + 1 + back.dims[0] * (at[1] + 1 + back.dims[1] * (at[2] + 1));
    if (written[static_cast<std::size_t>(v)] != read[static_cast<std::size_t>(w)]) ++different;
  }
  EXPECT_EQ(different, 0);
  EXPECT_EQ(read.front(), static_cast<float>(value_range(torus).max));
}

template <class T>
VoxelArray counting_voxels(std::size_t count) {
  std::vector<T> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<T>(i * 7 - 20));
  return values;
}

TEST(WriteVolume, EveryTypeAndItsVoxelsAreKept) {
  const TempFolder folder;
  Volume volume;
  volume.dims = {4, 3, 2};
  const std::vector<const char*> names{"a.nrrd", "a.nii", "a.nii.gz", "a.mha", "a.npy", "a.vti"};
  for (const VoxelArray& values :
       {counting_voxels<std::uint8_t>(24), counting_voxels<std::int8_t>(24),
        counting_voxels<std::uint16_t>(24), counting_voxels<std::int16_t>(24),
        counting_voxels<std::uint32_t>(24), counting_voxels<std::int32_t>(24),
        counting_voxels<float>(24), counting_voxels<double>(24)}) {
    volume.values = values;
    for (const char* name : names) {
      write_volume(volume, folder / name);
      const Volume back = read_volume(folder / name);
      EXPECT_EQ(back.dims, volume.dims) << name;
      EXPECT_EQ(back.values, values) << name << ' ' << type_name(values);
      EXPECT_FALSE(back.mask) << name;
      EXPECT_TRUE(back.warnings.empty()) << name;
    }
  }
  EXPECT_EQ(folder.entries(), 6);
}

/// The torus in a frame of its own, or without one.
Volume placed_torus(Frame frame) {
  Volume volume = make_shape("torus", {.size = 20}).volume;
  volume.level_set = false;
  volume.frame = frame;
  volume.spacing = {0.5, 0.25, 2.0};
  volume.origin = {};
  if (frame == Frame::index) return volume;
  volume.origin = {10.0, -20.125, 1e-7};
  volume.direction = {Vec3{0.6, 0.8, 0.0}, Vec3{-0.8, 0.6, 0.0}, Vec3{0.0, 0.0, -1.0}};
  return volume;
}

TEST(WriteVolume, WhereTheVoxelsLieIsKeptAsFarAsTheFormatCanSayIt) {
  const TempFolder folder;
  for (const Frame frame : {Frame::index, Frame::world, Frame::lps, Frame::ras}) {
    const Volume volume = placed_torus(frame);
    for (const char* name : {"a.nrrd", "a.nii.gz", "a.mha", "a.vti"}) {
      write_volume(volume, folder / name);
      const Volume back = read_volume(folder / name);
      const bool turns = (frame == Frame::lps && back.frame == Frame::ras) ||
                         (frame == Frame::ras && back.frame == Frame::lps);
      const bool is_said =
          frame == back.frame || turns || (frame == Frame::index && back.frame == Frame::world);
      EXPECT_EQ(left_out_of(volume, name).empty(), is_said) << name << ' ' << frame_name(frame);
      for (std::size_t a = 0; a < 3; ++a) {
        EXPECT_NEAR(back.spacing[a], volume.spacing[a], 1e-12) << name;
        for (std::size_t c = 0; c < 3; ++c) {
          const double sign = turns && c < 2 ? -1.0 : 1.0;
          // NIfTI has floats for it.
          EXPECT_NEAR(back.direction[a][c], sign * volume.direction[a][c], 1e-7) << name;
          EXPECT_NEAR(back.origin[c], sign * volume.origin[c], 1e-6) << name;
        }
      }
    }
  }
}

TEST(WriteVolume, UnitsAreKeptWhereTheFormatHasThem) {
  const TempFolder folder;
  Volume volume = placed_torus(Frame::ras);
  for (const char* unit : {"mm", "µm", "m"}) {
    volume.unit = unit;
    for (const char* name : {"a.nrrd", "a.nii"}) {
      EXPECT_TRUE(left_out_of(volume, name).empty()) << name;
      write_volume(volume, folder / name);
      EXPECT_EQ(read_volume(folder / name).unit, unit) << name;
    }
  }
  EXPECT_TRUE(contains(left_out_of(volume, "a.vti").back().text, "lengths are in m"));
  volume.frame = Frame::index;
  write_volume(volume, folder / "index.nrrd");
  EXPECT_EQ(read_volume(folder / "index.nrrd").unit, "m");
}

TEST(WriteVolume, NpyKeepsAMaskAndSaysThatItHasNoPlace) {
  const TempFolder folder;
  const Volume mask{
      .values = std::vector<std::uint8_t>{0, 1, 1, 0}, .dims = {2, 2, 1}, .mask = true};
  EXPECT_TRUE(left_out_of(mask, "mask.npy").empty());
  write_volume(mask, folder / "mask.npy");
  const Volume back = read_volume(folder / "mask.npy");
  EXPECT_TRUE(back.mask);
  EXPECT_EQ(back.values, mask.values);
  EXPECT_TRUE(contains(left_out_of(placed_torus(Frame::index), "a.npy").at(0).text,
                       "the spacing 0.5 0.25 2 and the place are left out"));
}

TEST(WriteVolume, NiftiRefusesAnAxisThatItsHeaderCannotState) {
  const TempFolder folder;
  const Volume line{.values = std::vector<std::uint8_t>(32768), .dims = {32768, 1, 1}};
  const std::string message =
      message_of<InvalidArgument>([&] { write_volume(line, folder / "line.nii"); });
  EXPECT_TRUE(contains(message, "32767 voxels along an axis")) << message;
  EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteVolume, ALevelSetIsSaidToBeOneByVdbAlone) {
  const Volume torus = make_shape("torus", {.size = 20}).volume;
  EXPECT_TRUE(left_out_of(torus, "a.vdb").empty());
  EXPECT_TRUE(contains(left_out_of(torus, "a.nrrd").at(0).text, "distances of a level set"));
}

TEST(WriteVolume, VdbIsStableOnceItHasBeenRead) {
  const TempFolder folder;
  write_volume(make_shape("ball", {.size = 16}).volume, folder / "one.vdb");
  const Volume one = read_volume(folder / "one.vdb");
  write_volume(one, folder / "two.vdb");
  const Volume two = read_volume(folder / "two.vdb");
  EXPECT_EQ(two.dims, one.dims);
  EXPECT_EQ(two.values, one.values);
  for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(two.origin[a], one.origin[a], 1e-12);
}

TEST(WriteVolume, VdbPadsAFogVolumeWithItsSmallestValue) {
  const TempFolder folder;
  const Volume fog{.values = std::vector<std::int16_t>{-1000, 5, 7, 9}, .dims = {2, 2, 1}};
  write_volume(fog, folder / "fog.vdb");
  const Volume back = read_volume(folder / "fog.vdb");
  EXPECT_FALSE(back.level_set);
  EXPECT_EQ(back.dims, (Index3{4, 4, 3}));
  EXPECT_EQ(value_range(back).min, -1000.0);
  EXPECT_EQ(std::get<std::vector<float>>(back.values)[2 + 4 * (2 + 4 * 1)], 9.0F);
}

TEST(WriteVolume, AnUnknownExtensionIsRefusedBeforeAnythingIsWritten) {
  const TempFolder folder;
  const Volume volume{.values = std::vector<std::uint8_t>{1}, .dims = {1, 1, 1}};
  const std::string message =
      message_of<InvalidArgument>([&] { write_volume(volume, folder / "a.stl"); });
  EXPECT_TRUE(contains(message, "a.stl") && contains(message, ".raw")) << message;
  EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteVolume, AFailureNamesTheFileAndLeavesNothing) {
  const TempFolder folder;
  Volume flat{.values = std::vector<float>{1.0F, 2.0F}, .dims = {2, 1, 1}};
  flat.direction[1] = flat.direction[0];
  const std::string message =
      message_of<InvalidInput>([&] { write_volume(flat, folder / "flat.vdb"); });
  EXPECT_TRUE(contains(message, "flat.vdb")) << message;
  EXPECT_EQ(folder.entries(), 0);
  EXPECT_THROW(write_volume(flat, folder / "none/flat.raw"), InvalidInput);
}

}  // namespace
}  // namespace isoloop
