#include "volume/formats/nrrd.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/byte_samples.h"
#include "tests/samples/damaged_files.h"
#include "tests/samples/nrrd_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/formats/nifti.h"
#include "volume/formats/raw.h"

namespace isoloop {
namespace {

using test::contains;
using test::dozen_voxels;
using test::message_of;
using test::nrrd_header;
using test::nrrd_plain;
using test::TempFolder;
using test::write_bytes;

class Nrrd : public ::testing::Test {
 protected:
  Volume read(const std::string& bytes, const FormatOptions& options = {},
              const VoxelLimits& limits = {}) const {
    write_bytes(folder_ / "a.nrrd", bytes);
    return read_nrrd(folder_ / "a.nrrd", options, limits);
  }
  // Of a header with these lines and the usual voxels.
  Volume with(const std::string& lines, const FormatOptions& options = {}) const {
    return read(nrrd_header(nrrd_plain + lines) + "\n" + dozen_voxels(Endian::little), options);
  }
  std::string refusal(const std::string& lines) const {
    return message_of<InvalidInput>([&] { with(lines); });
  }
  TempFolder folder_;
};

TEST_F(Nrrd, EveryEncodingAndByteOrderHoldsTheSameVoxels) {
  std::vector<std::int16_t> expected;
  for (std::int16_t i = 0; i < 12; ++i) expected.push_back(i);
  for (const Endian endian : {Endian::little, Endian::big}) {
    const std::string order =
        std::string("endian: ") + (endian == Endian::big ? "big" : "little") + "\n";
    const std::string bytes = dozen_voxels(endian);
    for (const std::string& file :
         {nrrd_header(order + "encoding: raw\n") + "\n" + bytes,
          nrrd_header(order + "encoding: gzip\nkey:=any value\n") + "\n" + test::gzip_bytes(bytes),
          nrrd_header(order + "encoding: raw\nline skip: 1\nbyte skip: 3\n") + "\nline\nabc" +
              bytes,
          nrrd_header(order + "encoding: raw\nbyte skip: -1\n") + "\nany bytes" + bytes,
          nrrd_header(order + "encoding: gz\nbyte skip: 2\n") + "\n" +
              test::gzip_bytes("ab" + bytes)}) {
      const Volume volume = read(file);
      EXPECT_EQ(volume.dims, (Index3{3, 2, 2}));
      EXPECT_EQ(std::get<std::vector<std::int16_t>>(volume.values), expected);
    }
  }
}

TEST_F(Nrrd, ADetachedHeaderNamesItsDataFile) {
  write_bytes(folder_ / "a.nhdr", nrrd_header(nrrd_plain + "data file: ./a.raw\n"));
  write_bytes(folder_ / "a.raw", dozen_voxels(Endian::little));
  EXPECT_EQ(read_nrrd(folder_ / "a.nhdr").dims, (Index3{3, 2, 2}));
  std::filesystem::remove(folder_ / "a.raw");
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read_nrrd(folder_ / "a.nhdr"); }), "a.raw"));
  write_bytes(folder_ / "a.nhdr", nrrd_header(nrrd_plain + "data file: /dev/zero\n"));
  EXPECT_THROW(read_nrrd(folder_ / "a.nhdr"), InvalidInput);
  write_bytes(folder_ / "a.nhdr", nrrd_header(nrrd_plain + "data file: LIST\na.raw\nb.raw\n"));
  EXPECT_TRUE(
      contains(message_of<InvalidInput>([&] { read_nrrd(folder_ / "a.nhdr"); }), "several files"));
}

TEST_F(Nrrd, APercentSignInANameIsNoPattern) {
  write_bytes(folder_ / "a.nhdr", nrrd_header(nrrd_plain + "data file: 77 %.raw\n"));
  write_bytes(folder_ / "77 %.raw", dozen_voxels(Endian::little));
  EXPECT_EQ(read_nrrd(folder_ / "a.nhdr").dims, (Index3{3, 2, 2}));
  write_bytes(folder_ / "a.nhdr", nrrd_header(nrrd_plain + "data file: a%02d.raw 1 2 1 2\n"));
  EXPECT_TRUE(
      contains(message_of<InvalidInput>([&] { read_nrrd(folder_ / "a.nhdr"); }), "several"));
}

TEST_F(Nrrd, HeadersMayEndTheirLinesWithCrLf) {
  std::string header = nrrd_header(nrrd_plain) + "\n";
  for (std::size_t at = header.find('\n'); at != std::string::npos; at = header.find('\n', at + 2))
    header.insert(at, "\r");
  EXPECT_EQ(read(header + dozen_voxels(Endian::little)).values, with("").values);
}

TEST_F(Nrrd, NoFileCutShortIsRead) {
  const auto path = folder_ / "cut.nrrd";
  for (const std::string& whole : {nrrd_header(nrrd_plain) + "\n" + dozen_voxels(Endian::little),
                                   nrrd_header("endian: big\nencoding: gzip\n") + "\n" +
                                       test::gzip_bytes(dozen_voxels(Endian::big))}) {
    test::expect_no_beginning_is_read(path, whole, [&] { read_nrrd(path); });
  }
  write_bytes(folder_ / "cut.raw", dozen_voxels(Endian::little));
  const auto detached = folder_ / "cut.nhdr";
  const std::string whole = nrrd_header("data file: cut.raw\n" + nrrd_plain);
  for (const std::string& more : {std::string(), std::string("spacings: 1 2 3.5\n")}) {
    test::expect_no_beginning_is_read_but_the_last_line(
        detached, nrrd_header(more + nrrd_plain + "data file: cut.raw\n"),
        [&] { read_nrrd(detached); });
  }
  test::expect_no_beginning_is_read_but_the_last_line(detached, whole,
                                                      [&] { read_nrrd(detached); });
  const std::string with_numbers = whole + "spacings: 1 2 3.5";
  for (std::size_t length = whole.size() + 1; length <= with_numbers.size(); ++length) {
    write_bytes(detached, with_numbers.substr(0, length));
    EXPECT_THROW(read_nrrd(detached), InvalidInput) << length;
  }
  std::string unended = whole;
  unended.pop_back();
  write_bytes(detached, unended);
  EXPECT_TRUE(contains(read_nrrd(detached).warnings.at(0).text, "no end"));
  write_bytes(detached, whole);
  test::expect_no_beginning_is_read(folder_ / "cut.raw", dozen_voxels(Endian::little),
                                    [&] { read_nrrd(detached); });
}

TEST_F(Nrrd, BytesTooManyAreRefused) {
  EXPECT_THROW(read(nrrd_header(nrrd_plain) + "\n" + dozen_voxels(Endian::little) + "x"),
               InvalidInput);
}

TEST_F(Nrrd, TheSpaceGivesFrameAndPlace) {
  const std::string place =
      "space directions: (0,2,0) (-3,0,0) (0,0,4)\nspace origin: (10,20,30)\n";
  const Volume lps = with("space: left-posterior-superior\n" + place);
  EXPECT_EQ(lps.frame, Frame::lps);
  EXPECT_EQ(lps.spacing, (Vec3{2, 3, 4}));
  EXPECT_EQ(lps.direction[1], (Vec3{-1, 0, 0}));
  EXPECT_EQ(lps.origin, (Vec3{10, 20, 30}));
  EXPECT_EQ(with("space: RAS\n" + place).frame, Frame::ras);
  const Volume las = with("space: left-anterior-superior\n" + place);
  EXPECT_EQ(las.frame, Frame::ras);
  EXPECT_EQ(las.origin, (Vec3{-10, 20, 30}));
  EXPECT_EQ(las.direction[1], (Vec3{1, 0, 0}));
  EXPECT_EQ(with("space: scanner-xyz\n" + place).frame, Frame::world);
  EXPECT_EQ(with("space dimension: 3\n" + place).frame, Frame::world);
  EXPECT_EQ(with("spacings: 1 2 3\n").spacing, (Vec3{1, 2, 3}));
  EXPECT_EQ(with("spacings: 1 2 3\n").frame, Frame::index);
}

TEST_F(Nrrd, PlacesThatMakeNoSenseAreRefused) {
  EXPECT_TRUE(contains(refusal("spacings: 1 -2 3\n"), "length of 2"));
  EXPECT_TRUE(contains(refusal("spacings: 1 0 3\n"), "spacing 0 along y"));
  EXPECT_TRUE(contains(refusal("spacings: 1 nan 3\n"), "nan"));
  EXPECT_THROW(with("spacings: 1 2\n"), InvalidInput);
  EXPECT_THROW(with("spacings: 1 2 x\n"), InvalidInput);
  const std::string space = "space: RAS\nspace directions: ";
  EXPECT_TRUE(contains(refusal(space + "(1,1,0) (0,1,0) (0,0,1)\n"), "45 degrees"));
  EXPECT_TRUE(contains(refusal(space + "(0,0,0) (0,1,0) (0,0,1)\n"), "spacing 0 along x"));
  EXPECT_THROW(with(space + "(1,0,0) (0,1,0)\n"), InvalidInput);
  EXPECT_THROW(with(space + "(1,0,0) (0,1,0) none\n"), InvalidInput);
  EXPECT_THROW(with(space + "(1,0,0) (0,1,0) (0,0,1\n"), InvalidInput);
  EXPECT_THROW(with("space: mars\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"), InvalidInput);
  EXPECT_EQ(with("spacings: 1 -2 3\n", {.spacing = Vec3{1, 1, 1}}).spacing, (Vec3{1, 1, 1}));
}

TEST_F(Nrrd, WhatIsNoVolumeIsRefusedByName) {
  EXPECT_TRUE(contains(refusal("kinds: vector domain domain\n"), "numbers per voxel"));
  EXPECT_TRUE(contains(refusal("kinds: RGB-color domain domain\n"), "rgb-color"));
  EXPECT_TRUE(contains(refusal("kinds: complex domain domain\n"), "complex"));
  const auto with_encoding = [&](const char* name) {
    return message_of<InvalidInput>([&] {
      read(nrrd_header(std::string("endian: big\nencoding: ") + name + "\n") + "\n1 2 3\n");
    });
  };
  EXPECT_TRUE(contains(with_encoding("ascii"), "'ascii'"));
  EXPECT_TRUE(contains(with_encoding("bzip2"), "'bzip2'"));
  EXPECT_TRUE(contains(
      message_of<InvalidInput>([&] { read(nrrd_header("encoding: raw\n") + "\n"); }), "endian"));
  EXPECT_THROW(with("sizes: 3 2 2\n"), InvalidInput);  // stated twice
  EXPECT_THROW(read("NRRD0009\n"), InvalidInput);
  EXPECT_THROW(read("NRRD0004\nno colon\n\n"), InvalidInput);
  EXPECT_THROW(
      read("NRRD0004\ntype: block\ndimension: 3\nsizes: 1 1 1\nencoding: raw\nendian: big\n\n"),
      InvalidInput);
  EXPECT_THROW(read("NRRD0004\ntype: char\ndimension: 3\nsizes: 0 1 1\nencoding: raw\n\n"),
               InvalidInput);
}

TEST_F(Nrrd, TheFourthAxisCountsFrames) {
  const std::string file =
      "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 2 2 1 3\nkinds: domain domain domain list\n"
      "space: LPS\nspace directions: (1,0,0) (0,1,0) (0,0,1) none\nencoding: raw\n\n"
      "abcdefghijkl";
  EXPECT_EQ(test::error_of<InvalidArgument>([&] { read(file); }).option, Option::frame);
  EXPECT_EQ(std::get<std::vector<std::uint8_t>>(read(file, {.frame = 1}).values).front(), 'e');
}

TEST_F(Nrrd, ABombIsRefusedBeforeMemoryIsAskedFor) {
  const std::string bomb =
      "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 100000 100000 100000\nencoding: gzip\n\n";
  const std::string file = bomb + test::gzip_bytes("tiny");
  EXPECT_EQ(test::error_of<LimitExceeded>([&] { read(file); }).excess.unit, Excess::Unit::bytes);
  EXPECT_THROW(read(file, {}, {.max_bytes = ~std::uint64_t{0}}), InvalidInput);
}

TEST(NrrdData, EveryFileOfTheDataFolderIsRead) {
  ISOLOOP_NEEDS("formats/FLAIR.nrrd");
  const auto dims_of = [](const std::string& name) {
    return read_nrrd(test::data("formats/" + name)).dims;
  };
  EXPECT_EQ(dims_of("FLAIR.nrrd"), (Index3{124, 160, 140}));
  EXPECT_EQ(dims_of("airway_p4_chopped.nrrd"), (Index3{311, 274, 362}));
  EXPECT_EQ(dims_of("ormir_test_nrrd.nrrd"), (Index3{25, 25, 25}));
  EXPECT_EQ(dims_of("seg3d_Skull.nrrd"), (Index3{160, 232, 160}));
  const Volume tooth = read_nrrd(test::data("formats/tooth.nhdr"));
  EXPECT_EQ(tooth.values, read_raw(test::data("formats/tooth.raw"), {.dims = Index3{103, 94, 161},
                                                                     .type = VoxelType::uint16,
                                                                     .endian = Endian::big})
                              .values);
}

TEST(NrrdData, OneImageInTwoFormatsLiesAtTheSamePlaceInTheWorld) {
  ISOLOOP_NEEDS("formats/FLAIR.nrrd");
  Volume nrrd = read_nrrd(test::data("formats/FLAIR.nrrd"));
  const Volume nifti = read_nifti(test::data("formats/FLAIR.nii.gz"));
  EXPECT_EQ(nrrd.values, nifti.values);
  EXPECT_EQ(nrrd.spacing, nifti.spacing);
  turn_frame(nrrd, Frame::ras, "FLAIR");
  for (const Vec3& index : {Vec3{0, 0, 0}, Vec3{123, 0, 0}, Vec3{0, 159, 0}, Vec3{123, 159, 139}}) {
    EXPECT_LT(distance(to_world(nrrd, index), to_world(nifti, index)), 1e-4);
  }
}

}  // namespace
}  // namespace isoloop
