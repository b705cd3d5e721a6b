#include "volume/slices/bmp.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/damaged_files.h"
#include "tests/samples/slice_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/slices/slice_file.h"

namespace isoloop {
namespace {

using test::BmpSample;
using test::contains;
using test::every_sort_of_bmp;
using test::message_of;
using test::TempFolder;
using test::write_bytes;
using Bytes = std::vector<std::uint8_t>;

class Bmp : public ::testing::Test {
 protected:
  Volume read(const std::string& bytes) const {
    write_bytes(folder_ / "a.bmp", bytes);
    return read_slice_volume(folder_ / "a.bmp", {}, {.max_bytes = 1 << 20});
  }
  std::string refusal(const std::string& bytes) const {
    return message_of<InvalidInput>([&] { read(bytes); });
  }
  TempFolder folder_;
};

TEST_F(Bmp, TheFirstRowIsTheTopmostWhicheverComesFirst) {
  for (const BmpSample& sample : every_sort_of_bmp()) {
    const Volume volume = read(sample.file());
    EXPECT_EQ(volume.dims, (Index3{3, 2, 1}));
    const std::uint8_t step = sample.bits == 8 ? 10 : 1;
    const Bytes& values = std::get<Bytes>(volume.values);
    for (std::uint8_t i = 0; i < 6; ++i) EXPECT_EQ(values[i], i * step) << sample.header;
  }
}

TEST_F(Bmp, NoFileCutShortIsRead) {
  for (const BmpSample& sample : every_sort_of_bmp()) {
    const auto path = folder_ / "cut.bmp";
    test::expect_no_beginning_is_read(path, sample.file(), [&] { read_slice_volume(path); });
  }
}

TEST_F(Bmp, WhatIsNoGreyImageIsRefusedByName) {
  BmpSample coloured = every_sort_of_bmp()[2];
  coloured.last_row[4] = 9;
  EXPECT_TRUE(contains(refusal(coloured.file()), "colour"));
  EXPECT_TRUE(contains(refusal(BmpSample{.palette = std::string("\1\2\3\0\0\0\0\0", 8)}.file()),
                       "palette of colours"));
  EXPECT_TRUE(contains(refusal(BmpSample{.palette = test::grey_palette(5, 4)}.file()),
                       "its palette does not"));
  EXPECT_TRUE(contains(refusal(BmpSample{.bits = 4}.file()), "4 bits"));
  EXPECT_TRUE(contains(refusal(BmpSample{.packing = 1}.file()), "compression 1"));
  EXPECT_TRUE(contains(refusal(BmpSample{.header = 130}.file()), "130 bytes"));
  EXPECT_TRUE(contains(refusal(BmpSample{.width = -3}.file()), "no size"));
  EXPECT_TRUE(contains(refusal(BmpSample{.height = 0}.file()), "no size"));
}

TEST_F(Bmp, SizesAreCheckedBeforeMemoryIsAskedFor) {
  for (const std::int32_t most : {0x7fffffff, 1 << 20}) {
    EXPECT_TRUE(
        contains(refusal(BmpSample{.width = most, .height = most}.file()), "its pixels end at"));
  }
  std::string bytes = BmpSample{}.file();
  test::put(bytes, 22, std::uint32_t{0x80000000U}, Endian::little);  // the least of heights
  EXPECT_TRUE(contains(refusal(bytes), "its pixels end at"));
  test::put(bytes, 10, std::uint32_t{20}, Endian::little);
  EXPECT_TRUE(contains(refusal(bytes), "within its palette"));
}

TEST_F(Bmp, FlippedBytesAreNoticedOrHarmless) {
  for (const BmpSample& sample : every_sort_of_bmp())
    test::expect_flipped_bytes_are_noticed_or_harmless(
        sample.file(), 1, [&](const std::string& bytes) { return read(bytes); });
}

}  // namespace
}  // namespace isoloop
