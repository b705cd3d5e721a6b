#include "volume/formats/dicom.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/damaged_files.h"
#include "tests/samples/dicom_samples.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

using test::contains;
using test::dicom_slice_at;
using test::DicomSlice;
using test::explicit_big;
using test::explicit_little;
using test::implicit_little;
using test::message_of;
using test::TempFolder;
using test::write_bytes;

class Dicom : public ::testing::Test {
 protected:
  void write(const std::string& name, const DicomSlice& slice) const {
    write_bytes(folder_ / name, slice.file());
  }
  // Slices at heights 0 to 3, with file names in another order.
  void write_series(const std::string& prefix = "", const std::string& series = "1.2.3") const {
    for (int z = 0; z < 4; ++z) {
      DicomSlice slice = dicom_slice_at(z);
      slice.series = series;
      write(prefix + std::to_string(9 - z), slice);
    }
  }
  Volume read(const FormatOptions& options = {}) const {
    return read_dicom(folder_.path(), options);
  }
  std::string refusal() const {
    return message_of<InvalidInput>([&] { read(); });
  }
  std::string refusal_of(const DicomSlice& slice) const {
    write("one", slice);
    return message_of<InvalidInput>([&] { read_dicom(folder_ / "one"); });
  }
  TempFolder folder_;
};

TEST_F(Dicom, SlicesAreOrderedByTheirPositions) {
  write_series();
  write_bytes(folder_ / "DICOMDIR", "not looked at");
  write_bytes(folder_ / "notes.txt", "not looked at");
  const Volume volume = read();
  EXPECT_EQ(volume.dims, (Index3{3, 2, 4}));
  EXPECT_EQ(volume.frame, Frame::lps);
  EXPECT_EQ(volume.origin, (Vec3{10, 20, 0}));
  EXPECT_EQ(volume.spacing, (Vec3{0.25, 0.5, 2}));
  const auto& values = std::get<std::vector<std::int16_t>>(volume.values);
  EXPECT_EQ(values.front(), 0);
  EXPECT_EQ(values.back(), 305);
  EXPECT_TRUE(volume.warnings.empty());
}

TEST_F(Dicom, EveryTransferSyntaxWithoutCompressionHoldsTheSamePixels) {
  for (const char* syntax : {explicit_little, explicit_big, implicit_little}) {
    DicomSlice slice;
    slice.syntax = syntax;
    write("one", slice);
    const Volume volume = read_dicom(folder_ / "one");
    EXPECT_EQ(std::get<std::vector<std::int16_t>>(volume.values),
              (std::vector<std::int16_t>{0, 1, 2, 3, 4, 5}))
        << syntax;
  }
}

TEST_F(Dicom, NoSliceCutShortIsRead) {
  for (const char* syntax : {explicit_little, explicit_big, implicit_little}) {
    DicomSlice slice;
    slice.syntax = syntax;
    const auto path = folder_ / "cut.dcm";
    test::expect_no_beginning_is_read(path, slice.file(), [&] { read_dicom(path); });
  }
}

TEST_F(Dicom, ASliceCutShortIsNotPassedOver) {
  write_series();
  const std::string whole = dicom_slice_at(3).file();
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    write_bytes(folder_ / "6", whole.substr(0, length));
    EXPECT_THROW(read(), InvalidInput) << length;
  }
}

TEST_F(Dicom, AMissingSliceIsMissed) {
  write_series();
  std::filesystem::remove(folder_ / "8");
  EXPECT_TRUE(contains(refusal(), "a slice is missing"));
}

TEST_F(Dicom, AMissingSliceIsWarnedOfWhereTheSpacingIsGiven) {
  write_series();
  std::filesystem::remove(folder_ / "8");
  const Volume volume = read({.spacing = Vec3{1, 1, 2}});
  EXPECT_EQ(volume.dims[2], 3);
  EXPECT_EQ(volume.spacing, (Vec3{1, 1, 2}));
  EXPECT_EQ(volume.unit, "");
  ASSERT_EQ(volume.warnings.size(), 1U);
  EXPECT_TRUE(contains(volume.warnings[0].text, "a slice is missing")) << volume.warnings[0].text;
}

TEST_F(Dicom, SlicesWithoutTheirFirstBytesAreRead) {
  for (const char* syntax : {explicit_little, implicit_little}) {
    for (int z = 0; z < 4; ++z) {
      DicomSlice slice = dicom_slice_at(z);
      slice.syntax = syntax;
      write_bytes(folder_ / std::to_string(9 - z), slice.data_set());
    }
    EXPECT_TRUE(holds_dicom(folder_.path()));
    const Volume volume = read();
    EXPECT_EQ(volume.dims, (Index3{3, 2, 4})) << syntax;
    EXPECT_EQ(std::get<std::vector<std::int16_t>>(volume.values).back(), 305) << syntax;
    const auto path = folder_ / "cut";
    DicomSlice slice;
    slice.syntax = syntax;
    test::expect_no_beginning_is_read(path, slice.data_set(), [&] { read_dicom(path); });
    std::filesystem::remove(path);
  }
}

TEST_F(Dicom, SlicesThatLackThePreambleAloneAreRead) {
  for (const std::size_t cut : {128U, 132U}) {
    for (int z = 0; z < 4; ++z)
      write_bytes(folder_ / std::to_string(z), dicom_slice_at(z).file().substr(cut));
    EXPECT_EQ(read().dims, (Index3{3, 2, 4})) << cut;
  }
}

TEST_F(Dicom, OtherFilesAreNotTakenForSlicesWithoutTheirFirstBytes) {
  std::string numbers;
  for (std::uint16_t i = 8; i < 200; ++i) numbers += test::number_bytes(i, Endian::little);
  write_bytes(folder_ / "a.bin", numbers);
  write_bytes(folder_ / "b.bin", std::string(200, '\x8'));
  write_bytes(folder_ / "c.bin", std::string("\x8\0\0\0\0\0\0\0\x8\0\0\0", 12));
  write_bytes(folder_ / "d.bin", std::string("\x8\0\1\0\0\0\0\0\x20\0\2\0", 12));
  EXPECT_FALSE(holds_dicom(folder_.path()));
}

TEST_F(Dicom, SlicesAreFoundInSubFolders) {
  write("DICOMDIR", {});
  write_bytes(folder_ / "VERSION", "of the disc");
  std::filesystem::create_directories(folder_ / "IMAGES/0");
  for (int z = 0; z < 4; ++z) write("IMAGES/0/" + std::to_string(z), dicom_slice_at(z));
  EXPECT_FALSE(holds_dicom(folder_.path()));
  EXPECT_TRUE(holds_dicom_within(folder_.path()));
  const Volume volume = read();
  EXPECT_EQ(volume.dims, (Index3{3, 2, 4}));
  EXPECT_EQ(volume.unit, "mm");
  EXPECT_TRUE(contains(volume.notes.at(0).text, "IMAGES"));
  write_bytes(folder_ / "IMAGES/0/4", dicom_slice_at(4).file().substr(0, 100));
  EXPECT_TRUE(contains(refusal(), "cut short"));
}

TEST_F(Dicom, AFolderWithSlicesIsReadWithoutItsSubFolders) {
  write_series();
  std::filesystem::create_directory(folder_ / "old");
  write("old/1", dicom_slice_at(7));
  EXPECT_EQ(read().dims[2], 4);
}

TEST_F(Dicom, UnevenDistancesAreWarnedOf) {
  write_series();
  DicomSlice moved = dicom_slice_at(1);
  moved.position = "10\\20\\2.1";
  write("8", moved);
  const Volume volume = read();
  ASSERT_EQ(volume.warnings.size(), 1U);
  EXPECT_TRUE(contains(volume.warnings[0].text, "1.9 to 2.1"));
}

TEST_F(Dicom, OfSeveralSeriesOneIsChosen) {
  write_series("a");
  write_series("b", "1.2.34");
  const auto error = test::error_of<InvalidArgument>([&] { read(); });
  const std::string message = error.what();
  EXPECT_EQ(error.option, Option::series);
  EXPECT_TRUE(contains(message, "1.2.3 (") && contains(message, "1.2.34 (")) << message;
  EXPECT_TRUE(test::advises(error.finding, Advice::choose_series) && contains(message, "4 slices"))
      << message;
  EXPECT_EQ(read({.series = "1.2.3"}).dims[2], 4);
  EXPECT_EQ(read({.series = ".34"}).dims[2], 4);
  EXPECT_THROW(read({.series = "Head"}), InvalidArgument);
  EXPECT_THROW(read({.series = "none"}), InvalidArgument);
}

TEST_F(Dicom, SeveralSlicesAtEachPlaceAreFrames) {
  write_series("a");
  for (int z = 0; z < 4; ++z) {
    DicomSlice slice = dicom_slice_at(z);
    slice.instance += 4;
    slice.pixels[0] = 77;
    write(std::string("b").append(std::to_string(z)), slice);
  }
  EXPECT_EQ(test::error_of<InvalidArgument>([&] { read(); }).option, Option::frame);
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(read({.frame = 0}).values)[0], 0);
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(read({.frame = 1}).values)[0], 77);
  std::filesystem::remove(folder_ / "b0");
  EXPECT_TRUE(contains(refusal(), "at one place"));
}

TEST_F(Dicom, RescalingGivesHounsfieldUnits) {
  DicomSlice slice;
  slice.is_signed = 0;
  slice.slope = "1";
  slice.intercept = "-1024";
  write("one", slice);
  const Volume volume = read();
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(volume.values)[5], -1019);
  EXPECT_TRUE(contains(volume.notes.at(0).text, "-1024"));
  slice.slope = "0.5";
  write("one", slice);
  EXPECT_EQ(std::get<std::vector<float>>(read().values)[5], -1021.5F);
  slice.slope = "0";
  EXPECT_TRUE(contains(refusal_of(slice), "slope 0"));
}

TEST_F(Dicom, SlicesMayHaveScalesOfTheirOwn) {
  for (int z = 0; z < 2; ++z) {
    DicomSlice slice = dicom_slice_at(z);
    slice.slope = std::to_string(2 + z);
    write(std::to_string(z), slice);
  }
  const Volume volume = read();
  const auto& values = std::get<std::vector<float>>(volume.values);
  EXPECT_EQ(values[1], 2.0F);
  EXPECT_EQ(values[7], 303.0F);
}

TEST_F(Dicom, OnlyTheStoredBitsCount) {
  DicomSlice slice;
  slice.stored = 12;
  slice.high = 11;
  slice.pixels = {0x0fff, 0x7001, 0x0800, 0, 0, 0};
  write("one", slice);
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(read().values),
            (std::vector<std::int16_t>{-1, 1, -2048, 0, 0, 0}));
  slice.is_signed = 0;
  write("one", slice);
  EXPECT_EQ(std::get<std::vector<std::uint16_t>>(read().values),
            (std::vector<std::uint16_t>{0x0fff, 1, 0x0800, 0, 0, 0}));
}

TEST_F(Dicom, WhatIsNoSliceOfNumbersIsRefusedByName) {
  EXPECT_TRUE(contains(refusal_of({.colours = "RGB", .samples = 3}), "RGB"));
  EXPECT_TRUE(contains(refusal_of({.colours = "PALETTE COLOR"}), "PALETTE"));
  EXPECT_TRUE(contains(refusal_of({.frames = "30"}), "30 frames"));
  EXPECT_TRUE(contains(refusal_of({.rows = 4}), "take 24 bytes"));
  EXPECT_TRUE(contains(refusal_of({.pixels = {}}), "no pixels"));
  EXPECT_TRUE(contains(refusal_of({.allocated = 12}), "12"));
  EXPECT_TRUE(contains(refusal_of({.spacing = "1"}), "1 numbers where 2"));
  EXPECT_TRUE(contains(refusal_of({.spacing = "1\\-1"}), "length of 1"));
  EXPECT_TRUE(contains(refusal_of({.spacing = "1\\x"}), "numbers should be"));
  EXPECT_TRUE(contains(refusal_of({.position = ""}), "with a stated spacing"));
  EXPECT_TRUE(contains(refusal_of({.syntax = "1.2.840.10008.1.2.1.99"}), "deflated"));
  EXPECT_TRUE(contains(refusal_of({.after = "garbage that is no element"}), "element"));
  EXPECT_NO_THROW(write("one", {.after = std::string(100, '\0')}); read_dicom(folder_ / "one"));
  // Fragments, as of JPEG.
  std::string packed = DicomSlice{.pixels = {}}.file();
  packed += std::string("\xe0\x7f\x10\0OB\0\0\xff\xff\xff\xff", 12);
  packed += std::string("\xfe\xff\0\xe0\2\0\0\0ab\xfe\xff\xdd\xe0\0\0\0\0", 18);
  write_bytes(folder_ / "one", packed);
  const auto error = test::error_of<InvalidInput>([&] { read_dicom(folder_ / "one"); });
  EXPECT_EQ(error.fault, Fault::unsupported);
  EXPECT_TRUE(test::advises(error.finding, Advice::unpack_slices));
}

TEST_F(Dicom, SlicesWithoutPlacesAreReadWhenTheSpacingIsGiven) {
  for (int z = 0; z < 3; ++z) {
    DicomSlice slice = dicom_slice_at(z);
    slice.position.clear();
    write(std::to_string(9 - z), slice);
  }
  const Volume volume = read({.spacing = Vec3{1, 1, 3}});
  EXPECT_EQ(volume.dims, (Index3{3, 2, 3}));
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(volume.values).back(), 205);
}

TEST_F(Dicom, ATiltedStackIsRefusedAsSheared) {
  for (int z = 0; z < 3; ++z) {
    DicomSlice slice = dicom_slice_at(z);
    slice.position = "0\\";
    slice.position.append(std::to_string(z)).append("\\").append(std::to_string(2 * z));
    write(std::to_string(z), slice);
  }
  EXPECT_TRUE(contains(refusal(), "sheared"));
}

TEST_F(Dicom, ABombIsRefusedBeforeMemoryIsAskedFor) {
  DicomSlice bomb{.rows = 65535, .columns = 65535};
  EXPECT_TRUE(contains(refusal_of(bomb), "take 8589672450 bytes"));
}

TEST_F(Dicom, KeepsToItsLimits) {
  write_series();
  EXPECT_EQ(test::error_of<LimitExceeded>([&] {
              read_dicom(folder_.path(), {}, {.max_bytes = 47});
            }).excess.needed,
            48U);
  EXPECT_NO_THROW(read_dicom(folder_.path(), {}, {.max_bytes = 48}));
  EXPECT_THROW(read_dicom(folder_.path(), {}, {.max_bytes = 0, .max_voxels = 23}), LimitExceeded);
}

TEST(DicomData, ReadsTheBrain) {
  ISOLOOP_NEEDS("dicom/papaya_brain");
  const Volume brain = read_dicom(test::data("dicom/papaya_brain"));
  EXPECT_EQ(brain.dims, (Index3{256, 256, 20}));
  EXPECT_NEAR(brain.spacing[2], 7.0, 0.001);
  ASSERT_EQ(brain.warnings.size(), 1U);
  EXPECT_TRUE(contains(brain.warnings[0].text, "6.95834 to 7.07088"));
}

}  // namespace
}  // namespace isoloop
