#include "volume/formats/meta_image.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/byte_samples.h"
#include "tests/samples/damaged_files.h"
#include "tests/samples/meta_image_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/formats/nifti.h"
#include "volume/formats/nrrd.h"
#include "volume/formats/raw.h"

namespace isoloop {
namespace {

using test::contains;
using test::dozen_voxels;
using test::message_of;
using test::meta_image_header;
using test::meta_image_packed;
using test::TempFolder;
using test::write_bytes;

class MetaImage : public ::testing::Test {
 protected:
  Volume read(const std::string& bytes, const FormatOptions& options = {},
              const VoxelLimits& limits = {}) const {
    write_bytes(folder_ / "a.mha", bytes);
    return read_meta_image(folder_ / "a.mha", options, limits);
  }
  Volume with(const std::string& lines, const FormatOptions& options = {}) const {
    return read(meta_image_header(lines) + dozen_voxels(Endian::little), options);
  }
  std::string refusal(const std::string& lines) const {
    return message_of<InvalidInput>([&] { with(lines); });
  }
  TempFolder folder_;
};

TEST_F(MetaImage, EveryEncodingAndByteOrderHoldsTheSameVoxels) {
  const VoxelArray expected = with("").values;
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(expected)[11], 11);
  const std::string big = "BinaryDataByteOrderMSB = True\n";
  for (const std::string& file : {meta_image_header(big) + dozen_voxels(Endian::big),
                                  meta_image_packed(test::zlib_bytes(dozen_voxels(Endian::little))),
                                  meta_image_packed(test::gzip_bytes(dozen_voxels(Endian::little))),
                                  meta_image_packed(test::zlib_bytes(dozen_voxels(Endian::big)),
                                                    "ElementByteOrderMSB = True\n")}) {
    EXPECT_EQ(read(file).values, expected);
  }
}

TEST_F(MetaImage, ADetachedHeaderNamesItsDataFile) {
  const auto path = folder_ / "a.mhd";
  write_bytes(path, meta_image_header("", "a b.raw"));
  write_bytes(folder_ / "a b.raw", dozen_voxels(Endian::little));
  EXPECT_EQ(read_meta_image(path).dims, (Index3{3, 2, 2}));
  write_bytes(folder_ / "a b.raw", "xyz" + dozen_voxels(Endian::little));
  EXPECT_THROW(read_meta_image(path), InvalidInput);
  for (const char* size : {"3", "-1"}) {
    write_bytes(path, meta_image_header(std::string("HeaderSize = ") + size + "\n", "a b.raw"));
    EXPECT_EQ(read_meta_image(path).dims, (Index3{3, 2, 2})) << size;
  }
  for (const char* list : {"LIST", "a%03d.raw 1 3 1"}) {
    write_bytes(path, meta_image_header("", list));
    EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read_meta_image(path); }), "several"));
  }
}

TEST_F(MetaImage, NoFileCutShortIsRead) {
  const auto path = folder_ / "cut.mha";
  for (const std::string& whole :
       {meta_image_header("") + dozen_voxels(Endian::little),
        meta_image_packed(test::zlib_bytes(dozen_voxels(Endian::little))),
        meta_image_header("CompressedData = True\n") +
            test::zlib_bytes(dozen_voxels(Endian::little))}) {
    test::expect_no_beginning_is_read(path, whole, [&] { read_meta_image(path); });
  }
  const auto detached = folder_ / "cut.mhd";
  write_bytes(folder_ / "cut.raw", dozen_voxels(Endian::little));
  test::expect_no_beginning_is_read_but_the_last_line(detached, meta_image_header("", "cut.raw"),
                                                      [&] { read_meta_image(detached); });
  std::string unended = meta_image_header("", "cut.raw");
  unended.pop_back();
  write_bytes(detached, unended);
  EXPECT_TRUE(contains(read_meta_image(detached).warnings.at(0).text, "no end"));
  write_bytes(detached, meta_image_header("", "cut.raw"));
  test::expect_no_beginning_is_read(folder_ / "cut.raw", dozen_voxels(Endian::little),
                                    [&] { read_meta_image(detached); });
}

TEST_F(MetaImage, AWrongCompressedSizeIsSaidWhereTheChecksumProvesTheVoxels) {
  const std::string packed = test::zlib_bytes(dozen_voxels(Endian::little));
  const auto stating = [&](const std::string& size) {
    return meta_image_header("CompressedData = True\nCompressedDataSize = " + size + "\n") + packed;
  };
  const Volume volume = read(stating("5"));
  EXPECT_EQ(volume.values, with("").values);
  ASSERT_EQ(volume.warnings.size(), 1U);
  EXPECT_TRUE(contains(volume.warnings[0].text, "states 5 compressed bytes"))
      << volume.warnings[0].text;
  EXPECT_TRUE(read(stating(std::to_string(packed.size()))).warnings.empty());
  EXPECT_THROW(read(stating("5") + "x"), InvalidInput);
  test::expect_no_beginning_is_read(folder_ / "a.mha", stating("5"),
                                    [&] { read_meta_image(folder_ / "a.mha"); });
}

TEST_F(MetaImage, APercentSignInANameIsNoPattern) {
  const auto path = folder_ / "77 %.mhd";
  write_bytes(path, meta_image_header("", "77 %.raw"));
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read_meta_image(path); }), "no such file"));
  write_bytes(folder_ / "77 %.raw", dozen_voxels(Endian::little));
  EXPECT_EQ(read_meta_image(path).dims, (Index3{3, 2, 2}));
  write_bytes(path, meta_image_header("", "a%03d.raw"));
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read_meta_image(path); }), "several"));
  write_bytes(folder_ / "a%03d.raw", dozen_voxels(Endian::little));
  EXPECT_EQ(read_meta_image(path).dims, (Index3{3, 2, 2}));
}

TEST_F(MetaImage, HeadersMayBeWrittenInAnyCaseAndWithAnyLineEnd) {
  const std::string header =
      "objecttype = image\r\nNDIMS = 3\r\n\r\ndimsize = 3 2 2\r\nElementType = met_short\r\n"
      "elementDATAfile = Local\r\n";
  EXPECT_EQ(read(header + dozen_voxels(Endian::little)).values, with("").values);
}

TEST_F(MetaImage, KeepsSpacingOriginAndDirection) {
  const Volume volume = with(
      "TransformMatrix = 0 1 0 -1 0 0 0 0 1\nOffset = 5 6 7\nElementSpacing = 1 2 3\n"
      "ElementSize = 9 9 9\nAnatomicalOrientation = RAI\n");
  EXPECT_EQ(volume.frame, Frame::lps);
  EXPECT_EQ(volume.spacing, (Vec3{1, 2, 3}));
  EXPECT_EQ(volume.origin, (Vec3{5, 6, 7}));
  EXPECT_EQ(volume.direction[0], (Vec3{0, 1, 0}));
  EXPECT_EQ(volume.direction[1], (Vec3{-1, 0, 0}));
}

TEST_F(MetaImage, PlacesThatMakeNoSenseAreRefused) {
  EXPECT_TRUE(contains(refusal("ElementSpacing = 1 -2 3\n"), "length of 2"));
  EXPECT_TRUE(contains(refusal("ElementSpacing = 1 0 3\n"), "spacing 0"));
  EXPECT_TRUE(contains(refusal("ElementSpacing = 1 nan 3\n"), "nan"));
  EXPECT_TRUE(contains(refusal("TransformMatrix = 1 1 0 0 1 0 0 0 1\n"), "degrees"));
  EXPECT_THROW(with("TransformMatrix = 1 0 0 1\n"), InvalidInput);
  EXPECT_THROW(with("Offset = 1 2 inf\n"), InvalidInput);
  EXPECT_NO_THROW(with("ElementSpacing = 1 -2 3\n", {.spacing = Vec3{1, 1, 1}}));
}

TEST_F(MetaImage, SlopeAndOffsetApply) {
  const Volume volume =
      with("ElementToIntensityFunctionSlope = 2\nElementToIntensityFunctionOffset = -3\n");
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(volume.values)[11], 19);
}

TEST_F(MetaImage, WhatIsNoVolumeIsRefusedByName) {
  EXPECT_TRUE(contains(refusal("ElementNumberOfChannels = 3\n"), "3 numbers per voxel"));
  EXPECT_TRUE(contains(refusal("NDims = 3\n"), "twice"));
  EXPECT_THROW(with("no equals sign\n"), InvalidInput);
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] {
                         read(
                             "NDims = 3\nDimSize = 1 1 1\nElementType = MET_UCHAR\n"
                             "BinaryData = False\nElementDataFile = LOCAL\n1\n");
                       }),
                       "as text"));
  EXPECT_THROW(read("ObjectType = Mesh\nElementDataFile = LOCAL\n"), InvalidInput);
  EXPECT_THROW(read("NDims = 9\nElementDataFile = LOCAL\n"), InvalidInput);
}

TEST_F(MetaImage, ABombIsRefusedBeforeMemoryIsAskedFor) {
  const std::string file =
      "NDims = 3\nBinaryData = True\nCompressedData = True\nDimSize = 99999 99999 99999\n"
      "ElementType = MET_DOUBLE\nElementDataFile = LOCAL\n" +
      test::zlib_bytes("tiny");
  EXPECT_EQ(test::error_of<LimitExceeded>([&] { read(file); }).excess.unit, Excess::Unit::bytes);
  EXPECT_THROW(read(file, {}, {.max_bytes = ~std::uint64_t{0}}), InvalidInput);
}

TEST(MetaImageData, EveryFileOfTheDataFolderIsRead) {
  ISOLOOP_NEEDS("formats/silicium.mha");
  EXPECT_EQ(read_meta_image(test::data("formats/silicium.mha")).dims, (Index3{104, 40, 40}));
  const Volume atom = read_meta_image(test::data("formats/hydrogenAtom.mha"));
  ISOLOOP_NEEDS("volumes/hydrogen_128x128x128_uint8.raw");
  EXPECT_EQ(atom.values, read_raw(test::data("volumes/hydrogen_128x128x128_uint8.raw"), {}).values);
}

TEST(MetaImageData, OneImageInThreeFormatsIsTheSame) {
  ISOLOOP_NEEDS("formats/ormir_test_mha.mha");
  const auto numbers = [](const Volume& volume) {
    return std::visit(
        [](const auto& values) { return std::vector<double>(values.begin(), values.end()); },
        volume.values);
  };
  const Volume mha = read_meta_image(test::data("formats/ormir_test_mha.mha"));
  Volume nifti = read_nifti(test::data("formats/ormir_test_nii.nii"));
  const Volume nrrd = read_nrrd(test::data("formats/ormir_test_nrrd.nrrd"));
  EXPECT_EQ(numbers(mha), numbers(nifti));
  EXPECT_EQ(numbers(mha), numbers(nrrd));
  turn_frame(nifti, Frame::lps, "ormir");
  for (const Volume* other : std::array<const Volume*, 2>{&nifti, &nrrd}) {
    EXPECT_EQ(other->frame, mha.frame);
    EXPECT_EQ(other->spacing, mha.spacing);
    EXPECT_LT(distance(to_world(*other, {24, 24, 24}), to_world(mha, {24, 24, 24})), 1e-6);
  }
}

}  // namespace
}  // namespace isoloop
