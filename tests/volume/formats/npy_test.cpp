#include "volume/formats/npy.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/byte_samples.h"
#include "tests/samples/damaged_files.h"
#include "tests/samples/npy_samples.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

using test::contains;
using test::message_of;
using test::npy_header;
using test::TempFolder;
using test::write_bytes;

// 0 to 23 as 16 bits: of array[z, y, x] with 2, 3 and 4 voxels in C order.
std::string voxels(Endian endian) {
  std::string bytes;
  for (std::int16_t i = 0; i < 24; ++i) bytes += test::number_bytes(i, endian);
  return bytes;
}

class Npy : public ::testing::Test {
 protected:
  Volume read(const std::string& bytes, const FormatOptions& options = {},
              const VoxelLimits& limits = {}) const {
    write_bytes(folder_ / "a.npy", bytes);
    return read_npy(folder_ / "a.npy", options, limits);
  }
  std::string refusal(const std::string& bytes) const {
    return message_of<InvalidInput>([&] { read(bytes); });
  }
  TempFolder folder_;
};

TEST_F(Npy, TheLastAxisIsX) {
  for (const char version : {1, 2, 3}) {
    const Volume volume =
        read(npy_header("<i2", "(2, 3, 4)", false, version) + voxels(Endian::little));
    EXPECT_EQ(volume.dims, (Index3{4, 3, 2}));
    EXPECT_EQ(std::get<std::vector<std::int16_t>>(volume.values)[5], 5);
  }
  EXPECT_EQ(read(npy_header(">i2", "(2, 3, 4)") + voxels(Endian::big)).values,
            read(npy_header("<i2", "(2, 3, 4)") + voxels(Endian::little)).values);
  EXPECT_EQ(read(npy_header("<i2", "(6, 4)") + voxels(Endian::little)).dims, (Index3{4, 6, 1}));
}

TEST_F(Npy, FortranOrderIsTheSameArray) {
  std::string bytes;
  for (std::int16_t x = 0; x < 4; ++x) {
    for (std::int16_t y = 0; y < 3; ++y) {
      for (std::int16_t z = 0; z < 2; ++z) {
        bytes += test::number_bytes(static_cast<std::int16_t>(x + 4 * y + 12 * z), Endian::little);
      }
    }
  }
  EXPECT_EQ(read(npy_header("<i2", "(2, 3, 4)", true) + bytes).values,
            read(npy_header("<i2", "(2, 3, 4)") + voxels(Endian::little)).values);
}

TEST_F(Npy, FourAxesBeginWithFrames) {
  const std::string file = npy_header("<i2", "(3, 2, 2, 2)") + voxels(Endian::little);
  EXPECT_EQ(test::error_of<InvalidArgument>([&] { read(file); }).option, Option::frame);
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(read(file, {.frame = 2}).values)[0], 16);
}

TEST_F(Npy, NoFileCutShortIsRead) {
  const auto path = folder_ / "cut.npy";
  test::expect_no_beginning_is_read(path, npy_header("<i2", "(2, 3, 4)") + voxels(Endian::little),
                                    [&] { read_npy(path); });
  EXPECT_THROW(read(npy_header("<i2", "(2, 3, 4)") + voxels(Endian::little) + "x"), InvalidInput);
}

TEST_F(Npy, WhatIsNoVolumeOfNumbersIsRefusedByName) {
  EXPECT_TRUE(contains(refusal(npy_header("<c8", "(1, 1, 1)") + "12345678"), "complex"));
  EXPECT_TRUE(contains(refusal(npy_header("|O", "(1, 1, 1)")), "'|O'"));
  EXPECT_TRUE(contains(refusal(npy_header("<f2", "(1, 1, 1)") + "12"), "<f2"));
  EXPECT_TRUE(contains(refusal(npy_header("<i2", "(24,)") + voxels(Endian::little)), "1 axes"));
  EXPECT_THROW(read(npy_header("<i2", "(2, -3, 4)")), InvalidInput);
  EXPECT_THROW(read(npy_header("<i2", "(2, 3, x)")), InvalidInput);
  EXPECT_THROW(read(npy_header("<i2", "(0, 3, 2)")), InvalidInput);
  EXPECT_TRUE(contains(refusal("PK\3\4, a whole archive"), "no .npy"));
  std::string records = npy_header("<i2", "(1, 1, 1)");
  records.replace(records.find("'<i2'"), 5, "[('a'");
  EXPECT_TRUE(contains(refusal(records), "records"));
}

TEST_F(Npy, ABombIsRefusedBeforeMemoryIsAskedFor) {
  for (const bool fortran : {false, true}) {
    const std::string bomb = npy_header("<f8", "(99999, 99999, 99999)", fortran) + "tiny";
    EXPECT_EQ(test::error_of<LimitExceeded>([&] { read(bomb); }).excess.unit, Excess::Unit::bytes);
    EXPECT_THROW(read(bomb, {}, {.max_bytes = ~std::uint64_t{0}}), InvalidInput);
  }
  EXPECT_THROW(read(npy_header("<i2", "(9999999999, 9999999999, 9999999999)")), LimitExceeded);
}

TEST_F(Npy, BoolsAreAMask) {
  EXPECT_TRUE(read(npy_header("|b1", "(1, 1, 2)") + std::string("\1\0", 2)).mask);
  EXPECT_FALSE(read(npy_header("|u1", "(1, 1, 2)") + std::string("\1\0", 2)).mask);
}

TEST_F(Npy, TheSpacingIsThatOfTheOptions) {
  const std::string file = npy_header("|b1", "(1, 1, 2)") + std::string("\1\0", 2);
  EXPECT_EQ(read(file).spacing, (Vec3{1, 1, 1}));
  EXPECT_EQ(read(file, {.spacing = Vec3{1, 2, 3}}).spacing, (Vec3{1, 2, 3}));
  EXPECT_EQ(read(file).frame, Frame::index);
}

}  // namespace
}  // namespace isoloop
