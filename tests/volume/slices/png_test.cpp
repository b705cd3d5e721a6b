#include "volume/slices/png.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/damaged_files.h"
#include "tests/samples/slice_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/slices/slice_file.h"

namespace isoloop {
namespace {

using test::contains;
using test::every_sort_of_png;
using test::message_of;
using test::png_chunk;
using test::PngSample;
using test::TempFolder;
using test::write_bytes;
using Bytes = std::vector<std::uint8_t>;

class Png : public ::testing::Test {
 protected:
  Volume read(const PngSample& sample, const VoxelLimits& limits = {}) const {
    write_bytes(folder_ / "a.png", sample.file());
    return read_slice_volume(folder_ / "a.png", {}, limits);
  }
  Bytes values(const PngSample& sample) const { return std::get<Bytes>(read(sample).values); }
  std::string refusal(const PngSample& sample) const {
    return message_of<InvalidInput>([&] { read(sample); });
  }
  TempFolder folder_;
};

TEST_F(Png, GreyIsReadFromEverySortOfPixel) {
  const auto sorts = every_sort_of_png();
  const Bytes plain{0, 1, 2, 3, 4, 5};
  const Bytes tens{0, 10, 20, 30, 40, 50};
  EXPECT_EQ(values(sorts[0]), plain);
  EXPECT_EQ(std::get<std::vector<std::uint16_t>>(read(sorts[1]).values),
            (std::vector<std::uint16_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(values(sorts[2]), (Bytes{255, 0, 255, 0, 255, 0}));
  EXPECT_EQ(values(sorts[3]), tens);
  EXPECT_EQ(values(sorts[4]), tens);
  EXPECT_EQ(values(sorts[5]), plain);
  EXPECT_EQ(values(sorts[6]), plain);
  EXPECT_EQ(values(sorts[7]), plain);
  EXPECT_EQ(read(sorts[0]).dims, (Index3{3, 2, 1}));
}

TEST_F(Png, NoFileCutShortIsRead) {
  for (const PngSample& sample : every_sort_of_png()) {
    const auto path = folder_ / "cut.png";
    test::expect_no_beginning_is_read(path, sample.file(), [&] { read_slice_volume(path); });
  }
}

TEST_F(Png, ColourAndTransparencyAreRefusedByName) {
  EXPECT_TRUE(
      contains(refusal({.colours = 2, .rows = {{"\0\0\0\1\1\1\2\2\2", 9}, "\3\3\3\4\7\4\5\5\5"}}),
               "colour"));
  EXPECT_TRUE(
      contains(refusal({.colours = 4, .rows = {{"\0\xff\1\xff\2\xff", 6}, "\3\xff\4\x7f\5\xff"}}),
               "transparent"));
  EXPECT_TRUE(contains(refusal({.colours = 3,
                                .before_pixels = png_chunk("PLTE", std::string("\0\0\1\1\1\1", 6)),
                                .rows = {{"\0\0\1", 3}, {"\1\1\1", 3}}}),
                       "colour"));
  EXPECT_TRUE(contains(refusal({.before_pixels = png_chunk("tRNS", std::string("\0\4", 2))}),
                       "transparent"));
}

TEST_F(Png, NoFlippedByteOfPixelsIsRead) {
  const std::string whole = PngSample{}.file();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    write_bytes(folder_ / "b.png", damaged);
    EXPECT_THROW(read_slice_volume(folder_ / "b.png", {}, {.max_bytes = 1 << 20}),
                 std::runtime_error)
        << at;
  }
}

TEST_F(Png, ABombIsRefusedBeforeMemoryIsAskedFor) {
  const PngSample bomb{.width = 0x7fffffff, .height = 0x7fffffff};
  EXPECT_EQ(test::error_of<LimitExceeded>([&] { read(bomb); }).excess.unit, Excess::Unit::bytes);
  const PngSample wide{.colours = 2, .rows = {std::string(9, 1), std::string(9, 1)}};
  EXPECT_THROW(read(wide, {.max_bytes = 17}), LimitExceeded);
  EXPECT_NO_THROW(read(wide, {.max_bytes = 18}));
}

}  // namespace
}  // namespace isoloop
