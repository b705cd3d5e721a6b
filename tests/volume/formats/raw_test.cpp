#include "volume/formats/raw.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

using test::contains;
using test::message_of;
using test::TempFolder;
using test::write_bytes;

template <class T>
const std::vector<T>& values_of(const Volume& volume) {
  return std::get<std::vector<T>>(volume.values);
}

TEST(RawName, StatesDimensionsAndType) {
  const auto layout = layout_from_name("/a/engine_256x200x128_uint8.raw");
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->dims, (Index3{256, 200, 128}));
  EXPECT_EQ(layout->type, VoxelType::uint8);
  EXPECT_EQ(layout_from_name("a_b_1x2x3_float64.raw")->type, VoxelType::float64);
  EXPECT_EQ(layout_from_name("a_1x2x3_uint16_v2.raw")->type, VoxelType::uint16);
  EXPECT_EQ(layout_from_name("1x2x3_int32.raw")->type, VoxelType::int32);
  EXPECT_EQ(layout_from_name("a_1x2x3_uint8_4x5x6_int8.raw")->dims, (Index3{4, 5, 6}));
}

TEST(RawName, StatesNothingWhenInDoubt) {
  for (const char* name :
       {"engine.raw", "engine_256x256_uint8.raw", "engine_256x256x128.raw", "e_0x2x3_uint8.raw",
        "e_1x2x3_uint64.raw", "e_1x2x3_uint80.raw", "e_-1x2x3_uint8.raw", "e1x2x3_uint8.raw",
        "e_99999999999999999999x2x3_uint8.raw", "_1x2x3_uint8/plain.raw", ""}) {
    EXPECT_FALSE(layout_from_name(name)) << name;
  }
  EXPECT_FALSE(layout_from_name(std::string(100000, 'x') + "_1x2x3_uint8.raw"));
}

TEST(RawReader, FirstAxisIsFastest) {
  const TempFolder folder;
  const auto path = folder / "a_3x2x2_uint8.raw";
  write_bytes(path, std::string("\0\1\2\3\4\5\6\7\10\11\12\377", 12));
  const Volume volume = read_raw(path, {.spacing = {0.5, 1.0, 2.0}});
  EXPECT_EQ(volume.dims, (Index3{3, 2, 2}));
  EXPECT_EQ(volume.spacing, (Vec3{0.5, 1.0, 2.0}));
  EXPECT_EQ(volume.frame, Frame::index);
  EXPECT_EQ(volume.origin, (Vec3{0.0, 0.0, 0.0}));
  EXPECT_FALSE(volume.level_set);
  EXPECT_EQ(values_of<std::uint8_t>(volume)[1 + 3 * (1 + 2 * 1)], 10);
  EXPECT_EQ(values_of<std::uint8_t>(volume)[11], 255);
}

TEST(RawReader, ReadsBothByteOrders) {
  const TempFolder folder;
  const auto path = folder / "a.raw";
  write_bytes(path, std::string("\x01\x02\xff\xfe", 4));
  RawOptions options{.dims = Index3{2, 1, 1}, .type = VoxelType::int16};
  EXPECT_EQ(values_of<std::int16_t>(read_raw(path, options)),
            (std::vector<std::int16_t>{513, -257}));
  options.endian = Endian::big;
  EXPECT_EQ(values_of<std::int16_t>(read_raw(path, options)), (std::vector<std::int16_t>{258, -2}));
  options.dims = Index3{1, 1, 1};
  options.type = VoxelType::uint32;
  EXPECT_EQ(values_of<std::uint32_t>(read_raw(path, options)).front(), 0x0102fffeU);
  write_bytes(path, std::string("\x3f\x80\0\0", 4));
  options.type = VoxelType::float32;
  EXPECT_EQ(values_of<float>(read_raw(path, options)).front(), 1.0F);
  write_bytes(path, std::string("\xc0\0\0\0\0\0\0\0", 8));
  options.type = VoxelType::float64;
  EXPECT_EQ(values_of<double>(read_raw(path, options)).front(), -2.0);
}

TEST(RawReader, ExplicitOptionsWinOverTheName) {
  const TempFolder folder;
  const auto path = folder / "a_4x1x1_uint8.raw";
  write_bytes(path, "abcd");
  const Volume wide = read_raw(path, {.dims = Index3{2, 1, 1}, .type = VoxelType::uint16});
  EXPECT_EQ(type_name(wide.values), "uint16");
  EXPECT_EQ(read_raw(path, {.dims = Index3{1, 2, 2}}).dims, (Index3{1, 2, 2}));
  EXPECT_EQ(type_name(read_raw(path, {.type = VoxelType::int8}).values), "int8");
}

TEST(RawReader, SkipsAHeader) {
  const TempFolder folder;
  const auto path = folder / "a_3x1x1_uint8.raw";
  write_bytes(path, "headabc");
  EXPECT_EQ(values_of<std::uint8_t>(read_raw(path, {.skip = 4})),
            (std::vector<std::uint8_t>{'a', 'b', 'c'}));
  EXPECT_THROW(read_raw(path, {}), InvalidInput);
  EXPECT_THROW(read_raw(path, {.skip = 3}), InvalidInput);
  EXPECT_THROW(read_raw(path, {.skip = 8}), InvalidInput);
  EXPECT_THROW(read_raw(path, {.skip = ~std::uint64_t{0}}), InvalidInput);
  EXPECT_THROW(read_raw(path, {.skip = ~std::uint64_t{0} - 2}), InvalidInput);
}

TEST(RawReader, RefusesAFileTruncatedAtAnyByte) {
  const TempFolder folder;
  const auto path = folder / "a_3x4x5_int16.raw";
  const std::string whole(120, '\7');
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write_bytes(path, whole.substr(0, length));
    EXPECT_THROW(read_raw(path, {}), InvalidInput) << length;
  }
  write_bytes(path, whole);
  EXPECT_NO_THROW(read_raw(path, {}));
}

TEST(RawReader, RefusesAFileOneByteLong) {
  const TempFolder folder;
  const auto path = folder / "a_3x4x5_int16.raw";
  write_bytes(path, std::string(121, '\7'));
  EXPECT_THROW(read_raw(path, {}), InvalidInput);
}

TEST(RawReader, SaysExpectedAndFoundBytesAndWhatToCheck) {
  const TempFolder folder;
  const auto path = folder / "a_3x4x5_int16.raw";
  write_bytes(path, std::string(119, '\7'));
  const auto error = test::error_of<InvalidInput>([&] { read_raw(path, {.skip = 2}); });
  const std::string message = error.what();
  EXPECT_TRUE(test::advises(error.finding, Advice::check_raw_layout));
  for (const char* part : {"a_3x4x5_int16.raw", "119", "122", "3 x 4 x 5", "int16"}) {
    EXPECT_TRUE(contains(message, part)) << part << " in " << message;
  }
}

TEST(RawReader, AsksForTheLayoutThatNothingStates) {
  const TempFolder folder;
  const auto path = folder / "a.raw";
  write_bytes(path, "abcd");
  EXPECT_EQ(test::error_of<InvalidArgument>([&] { read_raw(path, {}); }).option, Option::dims);
  EXPECT_EQ(test::error_of<InvalidArgument>([&] {
              read_raw(path, {.dims = Index3{4, 1, 1}});
            }).option,
            Option::voxel_type);
  EXPECT_NO_THROW(read_raw(path, {.dims = Index3{4, 1, 1}, .type = VoxelType::int8}));
}

TEST(RawReader, RefusesDimensionsAndSpacingsThatMakeNoVolume) {
  const TempFolder folder;
  const auto path = folder / "a_4x1x1_uint8.raw";
  write_bytes(path, "abcd");
  EXPECT_THROW(read_raw(path, {.dims = Index3{0, 1, 1}}), InvalidArgument);
  EXPECT_THROW(read_raw(path, {.dims = Index3{-2, -2, 1}}), InvalidArgument);
  for (const double length : {0.0, -1.0, 1.0 / 0.0, 0.0 / 0.0}) {
    EXPECT_THROW(read_raw(path, {.spacing = {1.0, length, 1.0}}), InvalidArgument) << length;
  }
}

TEST(RawReader, RefusesDimensionsWhoseProductOverflows) {
  const TempFolder folder;
  const auto path = folder / "a.raw";
  write_bytes(path, "");
  const std::int64_t big = std::int64_t{1} << 32;
  const RawOptions options{.dims = Index3{big, big, 1}, .type = VoxelType::uint8};
  EXPECT_THROW(read_raw(path, options), LimitExceeded);
}

TEST(RawReader, ChecksTheLimitBeforeItAllocatesOrReads) {
  const TempFolder folder;
  const auto path = folder / "a_1048576x1024x1024_float64.raw";
  write_bytes(path, "");
  std::filesystem::resize_file(path, std::uint64_t{1} << 43);  // sparse: 8 TiB of nothing
  EXPECT_THROW(read_raw(path, {}), LimitExceeded);
  const auto small = folder / "a_2x2x2_uint8.raw";
  write_bytes(small, "abcdefgh");
  EXPECT_THROW(read_raw(small, {}, {.max_bytes = 7}), LimitExceeded);
  EXPECT_NO_THROW(read_raw(small, {}, {.max_bytes = 8}));
}

TEST(RawReader, MissingFilesAreInvalidInputByName) {
  const std::string message =
      message_of<InvalidInput>([] { read_raw("/nowhere/a_2x2x2_uint8.raw", {}); });
  EXPECT_TRUE(contains(message, "/nowhere/a_2x2x2_uint8.raw")) << message;
}

template <class T>
void expect_round_trip(std::vector<T> values) {
  const TempFolder folder;
  const Volume volume{.values = values, .dims = {static_cast<std::int64_t>(values.size()), 1, 1}};
  const auto path = folder / "a.raw";
  {
    std::ofstream out(path, std::ios::binary);
    write_raw(out, volume);
  }
  const Volume back = read_raw(path, {.dims = volume.dims, .type = voxel_type(volume.values)});
  EXPECT_EQ(back.values, volume.values) << type_name(volume.values);
}

TEST(RawWriter, EveryTypeComesBackAsItWas) {
  expect_round_trip<std::uint8_t>({0, 1, 255});
  expect_round_trip<std::int8_t>({-128, 0, 127});
  expect_round_trip<std::uint16_t>({0, 258, 65535});
  expect_round_trip<std::int16_t>({-32768, 258, 32767});
  expect_round_trip<std::uint32_t>({0, 16909060, 4294967295U});
  expect_round_trip<std::int32_t>({-2147483647, 16909060, 2147483647});
  expect_round_trip<float>({-0.0F, 1e-42F, 3.4e38F});
  expect_round_trip<double>({-0.0, 4e-320, 1.7e308});
}

TEST(RawWriter, WritesLittleEndian) {
  std::ostringstream out;
  write_raw(out, {.values = std::vector<std::uint16_t>{0x0102}, .dims = {1, 1, 1}});
  EXPECT_EQ(out.str(), std::string("\x02\x01", 2));
}

TEST(RawReader, ReadsTheEngine) {
  const std::string name = "volumes/engine_256x256x128_uint8.raw";
  ISOLOOP_NEEDS(name);
  const Volume engine = read_raw(test::data(name), {});
  EXPECT_EQ(engine.dims, (Index3{256, 256, 128}));
  const auto& values = values_of<std::uint8_t>(engine);
  ASSERT_EQ(values.size(), 8388608U);
  EXPECT_EQ(value_range(engine).min, 0.0);
  EXPECT_EQ(value_range(engine).max, 255.0);
}

TEST(RawReader, ReadsABigEndianDetachedVolume) {
  const std::string name = "formats/tooth.raw";
  ISOLOOP_NEEDS(name);
  std::ifstream header(test::data("formats/tooth.nhdr"));
  std::string word;
  Index3 dims{};
  while (header >> word) {
    if (word == "sizes:") header >> dims[0] >> dims[1] >> dims[2];
  }
  RawOptions options{.dims = dims, .type = VoxelType::uint16, .endian = Endian::big};
  const double big = value_range(read_raw(test::data(name), options)).max;
  options.endian = Endian::little;
  EXPECT_LT(big, 5000.0);
  EXPECT_GT(value_range(read_raw(test::data(name), options)).max, 60000.0);
}

}  // namespace
}  // namespace isoloop
