// A part of a volume is the same voxels at the same places, whichever format they come from.
#include "volume/voxels/crop.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/byte_samples.h"
#include "tests/samples/mesh_samples.h"
#include "tests/samples/meta_image_samples.h"
#include "tests/samples/nifti_samples.h"
#include "tests/samples/npy_samples.h"
#include "tests/samples/nrrd_samples.h"
#include "tests/samples/volume_test_files.h"
#include "tests/samples/vti_samples.h"
#include "volume/files/read.h"
#include "volume/files/write.h"
#include "volume/shapes/shapes.h"

namespace isoloop {
namespace {

using test::contains;
using test::message_of;
using test::TempFolder;
using test::write_bytes;

constexpr Index3 whole_dims{5, 4, 3};

/// 0 to 59 of 16 bits, three frames of them.
std::string voxels(Endian endian) {
  std::string bytes;
  for (std::int16_t i = 0; i < 180; ++i) bytes += test::number_bytes(i, endian);
  return bytes;
}

Volume sample() {
  std::vector<std::int16_t> values(60);
  std::iota(values.begin(), values.end(), std::int16_t{0});
  return {.values = values, .dims = whole_dims, .spacing = {1, 2, 3}, .origin = {10, 20, 30}};
}

const CropBox middle{CropRange{1, 4}, CropRange{2, {}}, CropRange{{}, 2}};

TEST(Crop, KeepsTheVoxelsOfTheBoxAndTheirPlaceInTheWorld) {
  const Volume whole = sample();
  const Volume part = crop(whole, middle, "a");
  EXPECT_EQ(part.dims, (Index3{3, 2, 2}));
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(part.values),
            (std::vector<std::int16_t>{11, 12, 13, 16, 17, 18, 31, 32, 33, 36, 37, 38}));
  EXPECT_EQ(to_world(part, {0, 0, 0}), to_world(whole, {1, 2, 0}));
  EXPECT_EQ(to_world(part, {2, 1, 1}), to_world(whole, {3, 3, 1}));
  ASSERT_TRUE(part.part);
  EXPECT_EQ(part.part->first, (Index3{1, 2, 0}));
  EXPECT_EQ(part.part->whole, whole_dims);
  EXPECT_EQ(crop(whole, {}, "a").values, whole.values);
  Volume turned = whole;
  turned.direction = {Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}};
  EXPECT_EQ(to_world(crop(turned, middle, "a"), {0, 0, 0}), to_world(turned, {1, 2, 0}));
}

TEST(Crop, RefusesWhatIsNotInTheVolumeNamingItsDims) {
  const auto refusal = [](std::int64_t begin, std::int64_t end) {
    return message_of<InvalidArgument>([&] {
      crop(sample(), {CropRange{}, CropRange{begin, end}, CropRange{}}, "a.raw");
    });
  };
  for (const auto& [begin, end] : {std::pair{-1, 2}, {0, 5}, {4, 5}, {9, 12}}) {
    const std::string message = refusal(begin, end);
    EXPECT_TRUE(contains(message, "a.raw") && contains(message, "along y") &&
                contains(message, "0:4 in 5 x 4 x 3"))
        << message;
  }
  EXPECT_TRUE(contains(refusal(2, 2), "which are none") && contains(refusal(2, 2), "5 x 4 x 3"));
  EXPECT_TRUE(contains(refusal(3, 1), "3:1"));
}

class CropOfFile : public ::testing::Test {
 protected:
  /// Cropped on the way in, the file is what it is cropped afterwards.
  void expect_same_part(const std::string& name, ReadOptions options = {}) const {
    const auto path = folder_ / name;
    const Volume whole = read_volume(path, options);
    const std::vector<CropBox> boxes{middle,
                                     {},
                                     {CropRange{0, 1}, CropRange{0, 1}, CropRange{0, 1}},
                                     {CropRange{2, {}}, CropRange{1, {}}, CropRange{1, {}}},
                                     {CropRange{}, CropRange{1, 2}, CropRange{}}};
    for (const CropBox& box : boxes) {
      if (box[0].end == 4 && whole.dims[1] < 3) continue;  // of another shape
      options.crop = box;
      const Volume part = read_volume(path, options);
      const Volume expected = crop(whole, box, name);
      EXPECT_EQ(part.values, expected.values) << name;
      EXPECT_EQ(part.dims, expected.dims) << name;
      EXPECT_EQ(part.origin, expected.origin) << name;
      EXPECT_EQ(part.direction, whole.direction) << name;
      EXPECT_EQ(part.spacing, whole.spacing) << name;
      ASSERT_TRUE(part.part) << name;
      EXPECT_EQ(part.part->first, expected.part->first) << name;
      EXPECT_EQ(part.part->whole, whole.dims) << name;
      EXPECT_FALSE(part.stored_at) << name;
    }
    options.crop = CropBox{CropRange{0, 99}, CropRange{}, CropRange{}};
    EXPECT_THROW(read_volume(path, options), InvalidArgument) << name;
  }
  TempFolder folder_;
};

TEST_F(CropOfFile, IsTheSameInEveryFormat) {
  for (const Endian endian : {Endian::little, Endian::big}) {
    const std::string frame = voxels(endian).substr(0, 120);
    write_bytes(folder_ / "a.raw", "head" + frame);
    expect_same_part("a.raw", {.raw = {.dims = whole_dims,
                                       .type = VoxelType::int16,
                                       .endian = endian,
                                       .skip = 4,
                                       .spacing = {1, 2, 3}}});
    test::NiftiSample nifti{.endian = endian, .dim = {4, 5, 4, 3, 3, 1, 1, 1}};
    nifti.sform = 2;
    nifti.rows = {-2, 0, 0, 5, 0, 3, 0, 6, 0, 0, 4, 7};
    write_bytes(folder_ / "a.nii", nifti.file());
    expect_same_part("a.nii", {.format = {.frame = 1}});
    write_bytes(folder_ / "b.nii.gz", test::gzip_bytes(nifti.file()));
    expect_same_part("b.nii.gz", {.format = {.frame = 2}});
    const std::string order = endian == Endian::big ? "big" : "little";
    const std::string nrrd = "NRRD0004\ntype: short\ndimension: 3\nsizes: 5 4 3\nendian: " + order +
                             "\nspacings: 1 2 3\nencoding: ";
    write_bytes(folder_ / "a.nrrd", nrrd + "raw\n\n" + frame);
    write_bytes(folder_ / "b.nrrd", nrrd + "gzip\n\n" + test::gzip_bytes(frame));
    const std::string meta =
        "NDims = 3\nDimSize = 5 4 3\nElementType = MET_SHORT\nOffset = 1 2 3\n"
        "BinaryDataByteOrderMSB = " +
        std::string(endian == Endian::big ? "True" : "False") +
        "\nElementToIntensityFunctionSlope = 0.5\n";
    write_bytes(folder_ / "a.mha", meta + "ElementDataFile = LOCAL\n" + frame);
    write_bytes(folder_ / "b.mha", meta + "CompressedData = True\nElementDataFile = LOCAL\n" +
                                       test::zlib_bytes(frame));
    const std::string type = endian == Endian::big ? ">i2" : "<i2";
    write_bytes(folder_ / "a.npy", test::npy_header(type, "(3, 4, 5)") + frame);
    write_bytes(folder_ / "b.npy", test::npy_header(type, "(3, 4, 5)", true) + frame);
    for (const char* name : {"a.nrrd", "b.nrrd", "a.mha", "b.mha", "a.npy", "b.npy"}) {
      expect_same_part(name);
    }
  }
  test::VtiSample vti;
  write_bytes(folder_ / "a.vti", vti.file());
  expect_same_part("a.vti");
  write_volume(make_shape("ball", {.size = 20}).volume, folder_ / "a.vdb");
  expect_same_part("a.vdb");
}

TEST_F(CropOfFile, IntegersOf64BitsThatDoNotFitMayLieElsewhere) {
  std::string wide;
  for (std::int64_t i = 0; i < 60; ++i)
    wide += test::number_bytes(i == 0 ? std::int64_t{1} << 40 : i, Endian::little);
  write_bytes(folder_ / "a.npy", test::npy_header("<i8", "(3, 4, 5)") + wide);
  EXPECT_THROW(read_volume(folder_ / "a.npy"), InvalidInput);
  const Volume part = read_volume(folder_ / "a.npy", {.crop = middle});
  EXPECT_EQ(std::get<std::vector<std::int32_t>>(part.values)[0], 11);
}

TEST_F(CropOfFile, CountsThePartAloneAgainstTheLimitsWhereNoMoreIsHeld) {
  const std::string frame = voxels(Endian::little).substr(0, 120);
  write_bytes(folder_ / "a_5x4x3_int16.raw", frame);
  const auto read = [&](std::uint64_t max_bytes, std::uint64_t max_voxels) {
    return read_volume(folder_ / "a_5x4x3_int16.raw",
                       {.max_bytes = max_bytes, .max_voxels = max_voxels, .crop = middle});
  };
  EXPECT_NO_THROW(read(24, 12));
  EXPECT_THROW(read(23, 0), LimitExceeded);
  EXPECT_THROW(read(0, 11), LimitExceeded);
  write_bytes(folder_ / "b.npy", test::npy_header("<i2", "(3, 4, 5)", true) + frame);
  EXPECT_THROW(read_volume(folder_ / "b.npy", {.max_bytes = 130, .crop = middle}), LimitExceeded);
}

TEST_F(CropOfFile, AFileCutShortIsRefusedWhereverThePartLies) {
  const std::string frame = voxels(Endian::little).substr(0, 120);
  const ReadOptions first{.crop = CropBox{CropRange{0, 1}, CropRange{0, 1}, CropRange{0, 1}}};
  write_bytes(folder_ / "a_5x4x3_int16.raw", frame.substr(0, 119));
  EXPECT_THROW(read_volume(folder_ / "a_5x4x3_int16.raw", first), InvalidInput);
  test::NiftiSample nifti{.dim = {3, 5, 4, 3, 1, 1, 1, 1}};
  const std::string file = nifti.file();
  for (const std::string& whole : {file, test::gzip_bytes(file)}) {
    write_bytes(folder_ / "a.nii", whole.substr(0, whole.size() - 1));
    EXPECT_THROW(read_volume(folder_ / "a.nii", first), InvalidInput);
  }
}

TEST_F(CropOfFile, WhatLiesBeyondThePartNeedNotBeNumbers) {
  std::string floats;
  for (int i = 0; i < 8; ++i)
    floats += test::number_bytes(i == 7 ? std::nanf("") : 1.0F * i, Endian::little);
  write_bytes(folder_ / "a_2x2x2_float32.raw", floats);
  EXPECT_THROW(read_volume(folder_ / "a_2x2x2_float32.raw"), InvalidInput);
  const ReadOptions first{.crop = CropBox{CropRange{}, CropRange{}, CropRange{0, 1}}};
  EXPECT_EQ(read_volume(folder_ / "a_2x2x2_float32.raw", first).dims, (Index3{2, 2, 1}));
}

TEST_F(CropOfFile, MeshesAreReadWhole) {
  write_bytes(folder_ / "a.off",
              test::mesh_bytes(test::box_mesh({0, 0, 0}, {1, 1, 1}), test::MeshFormat::off));
  EXPECT_THROW(read_volume(folder_ / "a.off", {.voxel_size = {.resolution = 9}, .crop = CropBox{}}),
               InvalidArgument);
}

}  // namespace
}  // namespace isoloop
