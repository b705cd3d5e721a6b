#include "volume/slices/slice_folder.h"

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "core/base/errors.h"
#include "tests/samples/dicom_samples.h"
#include "tests/samples/slice_samples.h"
#include "tests/samples/tiff_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/files/read.h"

namespace isoloop {
namespace {

using test::BmpSample;
using test::contains;
using test::message_of;
using test::PngSample;
using test::TempFolder;
using test::write_bytes;

class SliceFolder : public ::testing::Test {
 protected:
  /// A PNG file whose voxels are all `value`.
  void write_png(const std::string& name, char value) const {
    const std::string row(3, value);
    write_bytes(folder_ / name, PngSample{.rows = {row, row}}.file());
  }
  Volume read(const FormatOptions& options = {}) const {
    return read_slice_folder(folder_.path(), options);
  }
  std::string refusal() const {
    return message_of<InvalidInput>([&] { read(); });
  }
  TempFolder folder_;
};

std::vector<std::uint8_t> first_of_each_slice(const Volume& volume) {
  std::vector<std::uint8_t> firsts;
  const auto& values = std::get<std::vector<std::uint8_t>>(volume.values);
  for (std::size_t i = 0; i < values.size(); i += 6) firsts.push_back(values[i]);
  return firsts;
}

TEST_F(SliceFolder, SlicesAreInTheOrderOfTheirNumbers) {
  for (const int z : {9, 10, 11}) {
    write_png("s" + std::to_string(z) + ".png", static_cast<char>(z));
  }
  const Volume volume = read();
  EXPECT_EQ(volume.dims, (Index3{3, 2, 3}));
  EXPECT_EQ(first_of_each_slice(volume), (std::vector<std::uint8_t>{9, 10, 11}));
  EXPECT_EQ(volume.spacing, (Vec3{1, 1, 1}));
  EXPECT_TRUE(volume.warnings.empty());
  EXPECT_EQ(read({.spacing = Vec3{1, 2, 3}}).spacing, (Vec3{1, 2, 3}));
  EXPECT_NO_THROW(read({.frame = 0, .channel = 0}));
  EXPECT_THROW(read({.frame = 1}), InvalidArgument);
  EXPECT_THROW(read({.channel = 1}), InvalidArgument);
}

TEST_F(SliceFolder, OneWarningNamesWhatIsNoSlice) {
  for (const char z : {'1', '2', '4'}) write_png(std::string(1, z) + ".png", z);
  for (const char* name : {"Thumbs.db", ".DS_Store", "a.log", "b.log", ".hidden.png"}) {
    write_bytes(folder_ / name, "x");
  }
  std::filesystem::create_directory(folder_ / "more");
  const Volume volume = read();
  ASSERT_EQ(volume.warnings.size(), 2U);
  EXPECT_TRUE(contains(volume.warnings[0].text, "after 2 comes 4")) << volume.warnings[0].text;
  for (const char* kind : {"Thumbs.db", ".DS_Store", "2 .log files", ".hidden.png", "1 folder"}) {
    EXPECT_TRUE(contains(volume.warnings[1].text, kind)) << volume.warnings[1].text;
  }
}

TEST_F(SliceFolder, SlicesThatDifferAreRefusedByName) {
  write_png("1.png", 1);
  write_bytes(folder_ / "2.png", PngSample{.height = 1, .rows = {"\1\1\1"}}.file());
  EXPECT_TRUE(contains(refusal(), "2.png: is 3 x 1 uint8, but 1.png is 3 x 2 uint8")) << refusal();
  write_bytes(folder_ / "2.png", test::every_sort_of_png()[1].file());
  EXPECT_TRUE(contains(refusal(), "2.png: is 3 x 2 uint16")) << refusal();
  write_bytes(folder_ / "3.bmp", BmpSample{}.file());
  EXPECT_TRUE(contains(refusal(), "several formats (3.bmp, 2 .png files)")) << refusal();
}

TEST_F(SliceFolder, ASliceCutShortIsNotPassedOver) {
  write_png("1.png", 1);
  const std::string whole = PngSample{}.file();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write_bytes(folder_ / "2.png", whole.substr(0, length));
    EXPECT_THROW(read(), InvalidInput) << length;
  }
}

TEST_F(SliceFolder, ThePictureOfAScannersSettingsIsNoSlice) {
  for (const char z : {'1', '2', '3'}) write_png(std::string("a_rec000") + z + ".png", z);
  write_bytes(folder_ / "a_rec_spr.bmp", BmpSample{}.file());
  const Volume volume = read();
  EXPECT_EQ(volume.dims[2], 3);
  ASSERT_EQ(volume.warnings.size(), 1U);
  EXPECT_TRUE(contains(volume.warnings[0].text, "a_rec_spr.bmp"));
}

TEST_F(SliceFolder, TheScannersLogStatesTheSpacing) {
  write_bytes(folder_ / "1.bmp", BmpSample{}.file());
  write_bytes(folder_ / "2.bmp", BmpSample{}.file());
  write_bytes(folder_ / "a.log",
              "[Acquisition]\r\nCamera Pixel Size (um)=9\r\nImage Pixel Size (um)=   13.60\r\n");
  Volume volume = read();
  EXPECT_EQ(volume.spacing, (Vec3{13.6, 13.6, 13.6}));
  EXPECT_EQ(volume.unit, "µm");
  EXPECT_TRUE(volume.warnings.empty());
  EXPECT_TRUE(contains(volume.notes.at(0).text, "a.log"));
  write_bytes(folder_ / "a_rec.log",
              "[Acquisition]\nImage Pixel Size (um)=13.60\n[Reconstruction]\nPixel Size (um)=13.5\n"
              "Section to Section Step=2\n[File name convention]\nPixel Size (um)=1\n");
  volume = read();
  EXPECT_EQ(volume.spacing, (Vec3{13.5, 13.5, 27}));
  ASSERT_EQ(volume.warnings.size(), 1U);
  EXPECT_TRUE(contains(volume.warnings[0].text, "a.log"));
  write_bytes(folder_ / "b_rec.log", "[Reconstruction]\nPixel Size (um)=4\n");
  volume = read();
  EXPECT_EQ(volume.spacing, (Vec3{1, 1, 1}));
  EXPECT_EQ(volume.unit, "");
  EXPECT_TRUE(contains(volume.warnings.at(0).text, "a_rec.log and b_rec.log state different"));
  volume = read({.spacing = Vec3{1, 1, 2}});
  EXPECT_EQ(volume.spacing, (Vec3{1, 1, 2}));
  EXPECT_EQ(volume.unit, "");
}

TEST_F(SliceFolder, TiffSlicesHaveOnePageEach) {
  for (const int z : {1, 2}) {
    const auto path = folder_ / (std::to_string(z) + ".tif");
    TIFF* file = TIFFOpen(path.c_str(), "w");
    test::write_tiff_page(file, {}, z);
    TIFFClose(file);
  }
  const Volume volume = read();
  EXPECT_EQ(volume.dims, (Index3{5, 4, 2}));
  EXPECT_EQ(std::get<std::vector<std::uint16_t>>(volume.values)[20], 200);
  write_bytes(folder_ / "3.tif", test::tiff_bytes({}, folder_ / "written"));
  EXPECT_TRUE(contains(refusal(), "2 pages"));
  std::filesystem::remove(folder_ / "1.tif");
  std::filesystem::remove(folder_ / "2.tif");
  EXPECT_EQ(read().dims, (Index3{5, 4, 2}));  // a folder of one file is that file
}

TEST_F(SliceFolder, KeepsToItsLimits) {
  for (const char z : {'1', '2'}) write_png(std::string(1, z) + ".png", z);
  EXPECT_THROW(read_slice_folder(folder_.path(), {}, {.max_bytes = 11}), LimitExceeded);
  EXPECT_NO_THROW(read_slice_folder(folder_.path(), {}, {.max_bytes = 12}));
}

TEST_F(SliceFolder, AFolderWithoutSlicesSaysWhatItHolds) {
  write_bytes(folder_ / "a.txt", "x");
  write_bytes(folder_ / "b.txt", "x");
  write_bytes(folder_ / "c.jpg", "x");
  const std::string message = message_of<InvalidInput>([&] { read_volume(folder_.path()); });
  EXPECT_TRUE(contains(message, "it holds c.jpg, 2 .txt files")) << message;
}

TEST_F(SliceFolder, PicturesBesideFoldersOfDicomSlicesAreRefused) {
  write_png("logo.png", 1);
  std::filesystem::create_directory(folder_ / "IMAGES");
  write_bytes(folder_ / "IMAGES" / "1", test::DicomSlice{}.file());
  const std::string message = message_of<InvalidInput>([&] { read_volume(folder_.path()); });
  EXPECT_TRUE(contains(message, "DICOM slices in folders within it")) << message;
  std::filesystem::remove(folder_ / "logo.png");
  EXPECT_EQ(read_volume(folder_.path()).dims, (Index3{3, 2, 1}));
}

TEST(SliceFolderData, TheFolderOfSlicesHasItsKnownCounts) {
  ISOLOOP_NEEDS("odd/tiff_folder");
  const Volume volume = read_volume(test::data("odd/tiff_folder"));
  EXPECT_EQ(volume.dims, (Index3{24, 20, 16}));
  const Betti betti = count_topology(view(volume), {100.0, InsideRule::above}).betti;
  EXPECT_EQ(betti.b0, 2);
  EXPECT_EQ(betti.b1, 3);
  EXPECT_EQ(betti.b2, 1);
}

}  // namespace
}  // namespace isoloop
