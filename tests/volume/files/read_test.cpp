#include "volume/files/read.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/base/errors.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

using test::contains;
using test::message_of;
using test::TempFolder;
using test::write_bytes;

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

TEST(ReadVolume, GoesByTheExtension) {
  const TempFolder folder;
  write_bytes(folder / "a_2x1x1_uint8.RAW", "ab");
  EXPECT_EQ(read_volume(folder / "a_2x1x1_uint8.RAW").dims, (Index3{2, 1, 1}));
  write_bytes(folder / "a.vdb", "this is no grid");
  EXPECT_THROW(read_volume(folder / "a.vdb"), InvalidInput);
}

TEST(ReadVolume, AnUnknownExtensionListsWhatIsSupported) {
  const TempFolder folder;
  write_bytes(folder / "a.xyz", "solid");
  const std::string message = message_of<InvalidInput>([&] { read_volume(folder / "a.xyz"); });
  EXPECT_TRUE(contains(message, ".raw") && contains(message, ".vdb")) << message;
  EXPECT_TRUE(contains(message, ".stl")) << message;
}

TEST(ReadVolume, StepIsOutOfScopeAndSaysSo) {
  const TempFolder folder;
  write_bytes(folder / "a.stp", "ISO-10303-21;");
  const std::string message = message_of<InvalidInput>([&] { read_volume(folder / "a.stp"); });
  EXPECT_TRUE(contains(message, "STEP") && contains(message, ".stl")) << message;
}

TEST(ReadVolume, VoxelSizesAreForMeshes) {
  const TempFolder folder;
  write_bytes(folder / "a_2x1x1_uint8.raw", "ab");
  EXPECT_THROW(read_volume(folder / "a_2x1x1_uint8.raw", {.voxel_size = {.resolution = 9}}),
               InvalidArgument);
  const std::string off =
      "OFF\n4 4 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  write_bytes(folder / "a.off", off);
  EXPECT_TRUE(read_volume(folder / "a.off", {.voxel_size = {.resolution = 9}}).level_set);
  EXPECT_THROW(read_volume(folder / "a.off"), InvalidArgument);
}

TEST(ReadVolume, MissingFilesFoldersAndDevicesAreRefusedByName) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "folder.raw");
  for (const auto& path :
       {folder / "none.raw", folder / "folder.raw", std::filesystem::path("/dev/zero")}) {
    const std::string message = message_of<InvalidInput>([&] { read_volume(path); });
    EXPECT_TRUE(contains(message, path.string())) << message;
  }
}

TEST(ReadVolume, AnUnreadableFileIsRefusedByName) {
  const TempFolder folder;
  const auto path = folder / "a_2x1x1_uint8.raw";
  write_bytes(path, "ab");
  std::filesystem::permissions(path, std::filesystem::perms::none);
  if (access(path.c_str(), R_OK) == 0) GTEST_SKIP() << "this user may read everything";
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read_volume(path); }), path.string()));
}

TEST(ReadVolume, RefusesNanNamingTheFirstVoxelAndTheWayOut) {
  const TempFolder folder;
  const auto path = folder / "a_3x2x2_float32.raw";
  std::vector<float> values(12, 1.0F);
  values[1 + 3 * (0 + 2 * 1)] = std::numeric_limits<float>::quiet_NaN();
  values[11] = -std::numeric_limits<float>::quiet_NaN();
  write_bytes(path, bytes_of(values));
  const auto error = test::error_of<InvalidInput>([&] { read_volume(path); });
  EXPECT_EQ(error.fault, Fault::not_finite);
  EXPECT_EQ(error.finding.file, path.string());
  EXPECT_EQ(error.finding.place, "voxel (1, 0, 1)");
  EXPECT_TRUE(test::advises(error.finding, Advice::replace_nan));
}

TEST(ReadVolume, ReplacesEveryNanAndNothingElse) {
  const TempFolder folder;
  const auto path = folder / "a_4x1x1_float64.raw";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  write_bytes(path, bytes_of(std::vector<double>{nan, -1.0, infinity, nan}));
  const Volume volume = read_volume(path, {.nan_as = 0.25});
  EXPECT_EQ(std::get<std::vector<double>>(volume.values),
            (std::vector<double>{0.25, -1.0, infinity, 0.25}));
}

TEST(ReadVolume, InfinityIsAValue) {
  const TempFolder folder;
  const auto path = folder / "a_1x1x1_float32.raw";
  write_bytes(path, bytes_of(std::vector<float>{-std::numeric_limits<float>::infinity()}));
  EXPECT_TRUE(std::isinf(std::get<std::vector<float>>(read_volume(path).values).front()));
}

TEST(ReadVolume, RefusesAReplacementThatIsNanOrDoesNotFit) {
  const TempFolder folder;
  const auto path = folder / "a_1x1x1_float32.raw";
  write_bytes(path, bytes_of(std::vector<float>{1.0F}));
  EXPECT_THROW(read_volume(path, {.nan_as = std::nan("")}), InvalidArgument);
  EXPECT_THROW(read_volume(path, {.nan_as = 1e300}), InvalidArgument);
}

TEST(ReadVolume, KeepsToItsMemoryLimit) {
  const TempFolder folder;
  const auto path = folder / "a_2x2x2_uint16.raw";
  write_bytes(path, "0123456789abcdef");
  EXPECT_THROW(read_volume(path, {.max_bytes = 15}), LimitExceeded);
  EXPECT_NO_THROW(read_volume(path, {.max_bytes = 16}));
}

}  // namespace
}  // namespace isoloop
