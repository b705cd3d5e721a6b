#include "tools/flags/flag_kinds.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/scratch_directory.h"

namespace isoloop {
namespace {

struct Case {
  const char* flag;
  std::function<void(VolumeFlags&)> give;
  std::vector<std::string> files;  // that it is for
};

const std::vector<std::string> volumes{"a.raw", "a.vdb", "a.nii.gz", "a.hdr", "a.nrrd",
                                       "a.mhd", "a.dcm", "a.tiff",   "a.PNG", "a.bmp",
                                       "a.npy", "a.vti", "folder"};
const std::vector<std::string> meshes{"a.stl", "a.PLY", "a.obj", "a.off"};

std::vector<std::string> all_but(std::vector<std::string> files, const std::string& file) {
  std::erase(files, file);
  return files;
}

std::vector<Case> all_cases() {
  return {{"--dims", [](VolumeFlags& f) { f.dims = "1 1 1"; }, {"a.raw"}},
          {"--type", [](VolumeFlags& f) { f.type = "u8"; }, {"a.raw"}},
          {"--endian", [](VolumeFlags& f) { f.endian = "little"; }, {"a.raw"}},
          {"--skip", [](VolumeFlags& f) { f.skip = 0; }, {"a.raw"}},
          {"--spacing", [](VolumeFlags& f) { f.spacing = "1"; }, all_but(volumes, "a.vdb")},
          {"--grid", [](VolumeFlags& f) { f.grid = "v"; }, {"a.vdb", "a.vti"}},
          {"--frame",
           [](VolumeFlags& f) { f.frame = 0; },
           {"a.nii.gz", "a.hdr", "a.nrrd", "a.mhd", "a.dcm", "a.tiff", "a.npy", "folder"}},
          {"--channel", [](VolumeFlags& f) { f.channel = 0; }, {"a.tiff", "folder"}},
          {"--series", [](VolumeFlags& f) { f.series = "1"; }, {"a.dcm", "folder"}},
          {"--affine", [](VolumeFlags& f) { f.affine = "sform"; }, {"a.nii.gz", "a.hdr"}},
          {"--label", [](VolumeFlags& f) { f.label = "1"; }, volumes},
          {"--crop", [](VolumeFlags& f) { f.crop = ":,:,:"; }, volumes},
          {"--nan-as", [](VolumeFlags& f) { f.nan_as = 0.0; }, volumes},
          {"--voxel", [](VolumeFlags& f) { f.voxel_size.length = 1.0; }, meshes},
          {"--resolution", [](VolumeFlags& f) { f.voxel_size.resolution = 9; }, meshes},
          {"--resolution", [](VolumeFlags& f) { f.voxel_size.automatic = true; }, meshes}};
}

TEST(FlagKinds, AFlagIsRefusedWhereItMeansNothing) {
  const ScratchDirectory scratch;
  std::filesystem::create_directory(scratch.path() / "folder");
  std::vector<std::string> files = volumes;
  files.insert(files.end(), meshes.begin(), meshes.end());
  for (const Case& one : all_cases()) {
    for (const std::string& file : files) {
      VolumeFlags flags;
      flags.file = (scratch.path() / file).string();
      one.give(flags);
      const bool fits = std::find(one.files.begin(), one.files.end(), file) != one.files.end();
      std::string message;
      try {
        check_flags_fit_file(flags);
      } catch (const InvalidArgument& error) {
        message = error.what();
      }
      EXPECT_EQ(message.empty(), fits) << one.flag << ' ' << file << ' ' << message;
      EXPECT_TRUE(fits || message.starts_with(one.flag)) << message;
    }
  }
}

TEST(FlagKinds, WithoutFlagsAndOfUnknownKindsNothingIsRefused) {
  for (const char* file : {"a.raw", "a.stl", "a.xyz", "none"}) {
    VolumeFlags flags;
    flags.file = file;
    EXPECT_NO_THROW(check_flags_fit_file(flags)) << file;
  }
  VolumeFlags unknown;
  unknown.file = "a.xyz";
  unknown.dims = "1 1 1";
  EXPECT_NO_THROW(check_flags_fit_file(unknown));
}

TEST(FlagsAgree, LabelsHaveNoIsoValueAndSayWhatIsInside) {
  VolumeFlags labels;
  labels.label = "3";
  EXPECT_THROW(check_flags_agree(labels, {.iso = "", .inside = "below"}), InvalidArgument);
  EXPECT_THROW(check_flags_agree(labels, {.iso = "1", .inside = ""}), InvalidArgument);
  EXPECT_NO_THROW(check_flags_agree(labels, {}));
  EXPECT_NO_THROW(check_flags_agree({}, {.iso = "1", .inside = ""}));
}

}  // namespace
}  // namespace isoloop
