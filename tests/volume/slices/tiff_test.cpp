#include "volume/slices/tiff.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/byte_samples.h"
#include "tests/samples/damaged_files.h"
#include "tests/samples/tiff_samples.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

using test::contains;
using test::every_sort_of_tiff;
using test::message_of;
using test::put;
using test::TempFolder;
using test::TiffSample;
using test::write_bytes;
using test::write_tiff_page;

class Tiff : public ::testing::Test {
 protected:
  std::string bytes_of(const TiffSample& sample) const {
    return test::tiff_bytes(sample, folder_ / "written");
  }
  Volume read(const std::string& bytes, const FormatOptions& options = {},
              const VoxelLimits& limits = {}) const {
    write_bytes(folder_ / "a.tif", bytes);
    return read_tiff(folder_ / "a.tif", options, limits);
  }
  std::string refusal(const TiffSample& sample) const {
    return message_of<InvalidInput>([&] { read(bytes_of(sample)); });
  }
  TempFolder folder_;
};

TEST_F(Tiff, EverySortHoldsTheSameVoxels) {
  for (const TiffSample& sample : every_sort_of_tiff()) {
    const Volume volume = read(bytes_of(sample));
    EXPECT_EQ(volume.dims, (Index3{5, 4, 2}));
    const auto& values = std::get<std::vector<std::uint16_t>>(volume.values);
    EXPECT_EQ(values[1], 1);
    EXPECT_EQ(values[5], 5);
    EXPECT_EQ(values[39], 119);
  }
}

TEST_F(Tiff, NoFileCutShortIsRead) {
  for (const TiffSample& sample : every_sort_of_tiff()) {
    const auto path = folder_ / "cut.tif";
    test::expect_no_beginning_is_read(path, bytes_of(sample), [&] { read_tiff(path); });
  }
}

TEST_F(Tiff, SamplesAreReadByTheirFormat) {
  EXPECT_EQ(type_name(read(bytes_of({.format = SAMPLEFORMAT_INT})).values), "int16");
  EXPECT_TRUE(contains(refusal({.format = SAMPLEFORMAT_IEEEFP}), "16 bits"));
  EXPECT_TRUE(contains(refusal({.format = SAMPLEFORMAT_COMPLEXINT}), "sample format 5"));
}

TEST_F(Tiff, ColoursAndChannelsAreRefusedByName) {
  EXPECT_TRUE(contains(refusal({.samples = 3}), "3 samples per pixel"));
  EXPECT_TRUE(contains(refusal({.samples = 2}), "2 samples per pixel"));
}

TEST_F(Tiff, FewerPagesThanStatedAreRefused) {
  EXPECT_TRUE(contains(refusal({.description = "ImageJ=1.53\nimages=3\nslices=3\n"}), "3 images"));
  EXPECT_NO_THROW(read(bytes_of({.description = "ImageJ=1.53\nimages=2\nslices=2\n"})));
}

TEST_F(Tiff, FramesOfAStackAreChosen) {
  const std::string file =
      bytes_of({.pages = 6, .description = "ImageJ=1.53\nimages=6\nslices=2\nframes=3\n"});
  const auto error = test::error_of<InvalidArgument>([&] { read(file); });
  EXPECT_EQ(error.option, Option::frame);
  EXPECT_EQ(error.finding.advice, std::vector<Advice>{Advice::choose_frame});
  const Volume second = read(file, {.frame = 1});
  EXPECT_EQ(second.dims[2], 2);
  EXPECT_EQ(std::get<std::vector<std::uint16_t>>(second.values)[0], 200);
}

TEST_F(Tiff, PagesThatDifferAreRefused) {
  const auto path = folder_ / "a.tif";
  TIFF* file = TIFFOpen(path.c_str(), "w");
  write_tiff_page(file, {}, 0);
  write_tiff_page(file, {.width = 6}, 1);
  TIFFClose(file);
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read_tiff(path); }), "differs"));
}

TEST_F(Tiff, DirectoriesInACircleAreRefused) {
  std::string bytes = bytes_of({.pages = 1});
  const auto at = load<std::uint32_t>(std::as_bytes(std::span(bytes)), 4, Endian::little);
  const auto entries = load<std::uint16_t>(std::as_bytes(std::span(bytes)), at, Endian::little);
  put(bytes, at + 2 + 12U * entries, at, Endian::little);
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read(bytes); }), "circle"));
}

TEST_F(Tiff, PagesThatShareOneListOfStripsAreRefused) {
  constexpr std::uint32_t strips = 2000;
  constexpr std::uint32_t pages = 200;
  constexpr std::uint32_t page_bytes = 30;
  std::string bytes("II*\0", 4);
  const auto add = [&](auto number) { bytes += test::number_bytes(number, Endian::little); };
  add(std::uint32_t{8 + 8 * strips});
  bytes.append(8 * std::size_t{strips}, '\0');
  for (std::uint32_t page = 1; page <= pages; ++page) {
    add(std::uint16_t{2});
    for (const std::uint16_t tag : {TIFFTAG_STRIPOFFSETS, TIFFTAG_STRIPBYTECOUNTS}) {
      add(tag);
      add(std::uint16_t{TIFF_LONG});
      add(strips);
      add(std::uint32_t{8});
    }
    add(page < pages ? 8 + 8 * strips + page * page_bytes : std::uint32_t{0});
  }
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read(bytes); }), "share one list"));
}

TEST_F(Tiff, ABombIsRefusedBeforeMemoryIsAskedFor) {
  std::string bytes = bytes_of({.pages = 1});
  const auto at = load<std::uint32_t>(std::as_bytes(std::span(bytes)), 4, Endian::little);
  put(bytes, at + 10, std::uint32_t{400000}, Endian::little);       // the width
  put(bytes, at + 12 + 10, std::uint32_t{900000}, Endian::little);  // the height
  bytes[at + 2 + 2] = 4;
  bytes[at + 12 + 2 + 2] = 4;  // both as 32 bits
  EXPECT_EQ(test::error_of<LimitExceeded>([&] { read(bytes); }).excess.unit, Excess::Unit::bytes);
}

TEST_F(Tiff, NegativesAmongPagesAndPreviewsAreRefused) {
  EXPECT_TRUE(contains(
      message_of<InvalidInput>([&] { read(bytes_of({.pages = 3, .white_is_zero_from = 1})); }),
      "page 1 differs from the first in size, type or whether 0 is white"));
  EXPECT_EQ(read(bytes_of({.pages = 3, .white_is_zero_from = 0})).dims, (Index3{5, 4, 3}));
  EXPECT_TRUE(
      contains(message_of<InvalidInput>([&] { read(bytes_of({.pages = 3, .reduced_from = 2})); }),
               "page 2 is a reduced picture"));
}

TEST_F(Tiff, FlippedBytesAreNoticedOrHarmless) {
  for (const TiffSample& sample : every_sort_of_tiff())
    test::expect_flipped_bytes_are_noticed_or_harmless(
        bytes_of(sample), 3,
        [&](const std::string& bytes) { return read(bytes, {}, {.max_bytes = 1 << 20}); });
}

TEST(TiffData, ReadsTheCochlea) {
  ISOLOOP_NEEDS("formats/bat-cochlea_sub25.tif");
  EXPECT_EQ(read_tiff(test::data("formats/bat-cochlea_sub25.tif")).dims, (Index3{30, 39, 29}));
}

}  // namespace
}  // namespace isoloop
