#include "volume/voxels/stored_voxels.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/byte_samples.h"
#include "tests/samples/damaged_files.h"

namespace isoloop {
namespace {

using test::TempFolder;
using test::write_bytes;

TEST(StoredVoxels, WholeScalesKeepIntegersExact) {
  const VoxelArray stored = std::vector<std::uint16_t>{0, 4095};
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(rescaled(stored, 1, -1024, "a")),
            (std::vector<std::int16_t>{-1024, 3071}));
  EXPECT_EQ(std::get<std::vector<std::int32_t>>(rescaled(stored, 10, 0, "a"))[1], 40950);
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(rescaled(stored, -2, 1, "a"))[1], -8189);
  const VoxelArray wide = std::vector<std::uint32_t>{4294967295U};
  EXPECT_EQ(std::get<std::vector<double>>(rescaled(wide, 2, 0, "a"))[0], 8589934590.0);
  EXPECT_EQ(std::get<std::vector<std::uint32_t>>(rescaled(wide, 1, -5, "a"))[0], 4294967290U);
}

TEST(StoredVoxels, OtherScalesGiveFloatingPoint) {
  const VoxelArray bytes = std::vector<std::uint8_t>{2};
  EXPECT_EQ(std::get<std::vector<float>>(rescaled(bytes, 0.5, 1, "a"))[0], 2.0F);
  const VoxelArray wide = std::vector<std::int32_t>{3};
  EXPECT_EQ(std::get<std::vector<double>>(rescaled(wide, 0.1, 0, "a"))[0], 0.1 * 3);
  EXPECT_THROW(rescaled(bytes, 0, 1, "a"), InvalidInput);
  EXPECT_THROW(rescaled(bytes, std::nan(""), 1, "a"), InvalidInput);
  EXPECT_THROW(rescaled(bytes, 1, INFINITY, "a"), InvalidInput);
  EXPECT_EQ(rescaled(bytes, 1, 0, "a"), bytes);
}

TEST(StoredVoxels, TheLimitCountsWhatScalingTakes) {
  VoxelLayout layout{.dims = {10, 1, 1}, .type = StoredType::int16};
  EXPECT_NO_THROW(check_layout(layout, {.max_bytes = 20}, "a"));
  layout.slope = 2;
  EXPECT_THROW(check_layout(layout, {.max_bytes = 59}, "a"), LimitExceeded);
  EXPECT_NO_THROW(check_layout(layout, {.max_bytes = 60}, "a"));
  EXPECT_THROW(check_layout(layout, {.max_bytes = 0, .max_voxels = 9}, "a"), LimitExceeded);
  layout.dims[1] = 0;
  EXPECT_THROW(check_layout(layout, {}, "a"), InvalidInput);
  layout = {.dims = {std::int64_t{1} << 40, 1, 1}, .frames = ~std::uint64_t{0}};
  EXPECT_THROW(check_layout(layout, {.max_bytes = ~std::uint64_t{0}}, "a"), InvalidInput);
}

TEST(StoredVoxels, IntegersOf64BitsMustFit32) {
  const TempFolder folder;
  const auto path = folder / "a";
  const auto read = [&](std::uint64_t value) {
    write_bytes(path, test::number_bytes(value, Endian::big));
    ByteStream stream(path, Packing::plain);
    Volume volume;
    read_voxels(stream, {.type = StoredType::uint64, .endian = Endian::big}, 0, {}, "a", volume);
    EXPECT_FALSE(volume.stored_at);
    return volume.values;
  };
  EXPECT_EQ(std::get<std::vector<std::uint32_t>>(read(4294967295U))[0], 4294967295U);
  EXPECT_THROW(read(std::uint64_t{1} << 32), InvalidInput);
}

TEST(ByteStream, AccountsForPlainBytes) {
  const TempFolder folder;
  const auto path = folder / "a";
  write_bytes(path, "0123456789");
  ByteStream stream(path, Packing::plain, 3);
  EXPECT_EQ(stream.most_left(), 7U);
  EXPECT_NO_THROW(stream.check_room(7, "it"));
  EXPECT_THROW(stream.check_room(8, "it"), InvalidInput);
  stream.skip(6, "it");
  EXPECT_THROW(stream.expect_end("it"), InvalidInput);
  EXPECT_THROW(ByteStream(path, Packing::plain, 11), InvalidInput);
  EXPECT_THROW(ByteStream(folder / "none", Packing::plain), InvalidInput);
  EXPECT_THROW(ByteStream("/dev/zero", Packing::plain), InvalidInput);
}

TEST(ByteStream, KnowsHowMuchCompressedBytesCanHold) {
  const TempFolder folder;
  const auto path = folder / "a";
  write_bytes(path, test::gzip_bytes(std::string(1000000, '\0')));
  ByteStream stream(path, Packing::gzip);
  EXPECT_NO_THROW(stream.check_room(1000000, "it"));
  EXPECT_THROW(stream.check_room(std::uint64_t{1} << 40, "it"), InvalidInput);
  EXPECT_NO_THROW(stream.skip(1000000, "it"));
  EXPECT_NO_THROW(stream.expect_end("it"));
}

TEST(ByteStream, AHeaderIsNotReadWithoutEnd) {
  const TempFolder folder;
  const auto path = folder / "a";
  std::string zeros;
  zeros.resize(20'000'000);
  write_bytes(path, test::gzip_bytes(zeros));
  ByteStream stream(path, Packing::gzip);
  EXPECT_THROW(stream.skip_rest("it"), InvalidInput);
}

}  // namespace
}  // namespace isoloop
