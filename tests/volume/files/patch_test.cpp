#include "volume/files/patch.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/byte_samples.h"
#include "tests/samples/meta_image_samples.h"
#include "tests/samples/nifti_samples.h"
#include "tests/samples/npy_samples.h"
#include "tests/samples/nrrd_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/base/file_kind.h"
#include "volume/files/read.h"

namespace isoloop {
namespace {

using test::TempFolder;
using test::write_bytes;

struct Sample {
  std::string name;
  std::string bytes;
  bool packed = false;
  ReadOptions options{};
};

/// Twelve voxels of 16 bits, 0 to 11, in each format whose voxels can be replaced where they are.
std::vector<Sample> samples() {
  const test::NiftiSample little;
  test::NiftiSample big;
  big.endian = Endian::big;
  test::NiftiSample frames;
  frames.dim = {4, 3, 2, 2, 3, 1, 1, 1};
  ReadOptions second;
  second.format.frame = 1;
  ReadOptions raw;
  raw.raw.dims = Index3{3, 2, 2};
  raw.raw.type = VoxelType::int16;
  raw.raw.skip = 5;
  raw.raw.endian = Endian::big;
  const std::string voxels = test::dozen_voxels(Endian::little);
  return {
      {"little.nii", little.file()},
      {"big.nii", big.file()},
      {"packed.nii.gz", test::gzip_bytes(big.file()), true},
      {"frames.nii", frames.file(), false, second},
      {"frames.nii.gz", test::gzip_bytes(frames.file()), true, second},
      {"plain.mha", test::meta_image_header("") + voxels},
      {"plain.nrrd", test::nrrd_header(test::nrrd_plain) + "\n" + voxels},
      {"packed.nrrd",
       test::nrrd_header("endian: little\nencoding: gzip\n") + "\n" + test::gzip_bytes(voxels),
       true},
      {"plain.npy", test::npy_header("<i2", "(2, 2, 3)") + voxels},
      {"skipped.raw", "12345" + test::dozen_voxels(Endian::big), false, raw},
  };
}

TEST(Patch, ReplacesTheVoxelsThatAreListedAndKeepsEveryOtherByte) {
  const TempFolder folder;
  for (const Sample& sample : samples()) {
    const auto path = folder / sample.name;
    write_bytes(path, sample.bytes);
    Volume volume = read_volume(path, sample.options);
    ASSERT_TRUE(volume.stored_at) << sample.name;
    auto& values = std::get<std::vector<std::int16_t>>(volume.values);
    const std::vector<std::size_t> listed{0, 4, 11};
    for (const std::size_t voxel : listed)
      values[voxel] = static_cast<std::int16_t>(~values[voxel]);
    std::ostringstream out;
    write_patched(volume, listed, out);
    write_bytes(path, out.str());
    const Volume again = read_volume(path, sample.options);
    EXPECT_EQ(again.values, volume.values) << sample.name;
    EXPECT_EQ(again.origin, volume.origin) << sample.name;
    if (sample.packed) continue;
    ASSERT_EQ(out.str().size(), sample.bytes.size()) << sample.name;
    std::size_t changed = 0;
    for (std::size_t i = 0; i < sample.bytes.size(); ++i)
      changed += out.str()[i] != sample.bytes[i] ? 1 : 0;
    EXPECT_EQ(changed, 2 * listed.size()) << sample.name;
  }
}

TEST(Patch, FormatsThatMayBePatchedAreThoseOfTheSamples) {
  std::set<FileKind> patched;
  for (const Sample& sample : samples()) patched.insert(file_format(sample.name)->kind);
  for (const FileFormat& format : file_formats())
    EXPECT_EQ(format.may_be_patched, patched.contains(format.kind)) << format.name;
}

TEST(Patch, NothingListedIsTheSameFile) {
  const TempFolder folder;
  for (const Sample& sample : samples()) {
    if (sample.packed) continue;
    write_bytes(folder / sample.name, sample.bytes);
    const Volume volume = read_volume(folder / sample.name, sample.options);
    std::ostringstream out;
    write_patched(volume, {}, out);
    EXPECT_EQ(out.str(), sample.bytes) << sample.name;
  }
}

TEST(Patch, AFileThatGotShorterMeanwhileIsRefused) {
  const TempFolder folder;
  const test::NiftiSample sample;
  write_bytes(folder / "a.nii", sample.file());
  const Volume volume = read_volume(folder / "a.nii");
  write_bytes(folder / "a.nii", sample.file().substr(0, sample.file().size() - 1));
  std::ostringstream out;
  EXPECT_THROW(write_patched(volume, {}, out), InvalidInput);
}

TEST(Patch, VoxelsThatAreScaledTurnedOrPackedInBlocksHaveNoPlace) {
  const TempFolder folder;
  test::NiftiSample scaled;
  scaled.slope = 2;
  const std::string voxels = test::dozen_voxels(Endian::little);
  const std::vector<Sample> others{
      {"scaled.nii", scaled.file()},
      {"turned.npy", test::npy_header("<i2", "(2, 2, 3)", true) + voxels},
      {"packed.mha", test::meta_image_packed(test::zlib_bytes(voxels))},
  };
  for (const Sample& sample : others) {
    write_bytes(folder / sample.name, sample.bytes);
    EXPECT_FALSE(read_volume(folder / sample.name).stored_at) << sample.name;
  }
}

}  // namespace
}  // namespace isoloop
