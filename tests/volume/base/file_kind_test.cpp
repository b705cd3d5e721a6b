#include "volume/base/file_kind.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

TEST(FileKind, GoesByTheExtensionWhateverItsCase) {
  EXPECT_EQ(file_kind("a/b.raw"), FileKind::raw);
  EXPECT_EQ(file_kind("a/b.VDB"), FileKind::vdb);
  EXPECT_EQ(file_kind("a/b.NII.gz"), FileKind::nifti);
  EXPECT_EQ(file_kind("b.hdr"), FileKind::nifti);
  EXPECT_EQ(file_kind("b.nhdr"), FileKind::nrrd);
  EXPECT_EQ(file_kind("b.PNG"), FileKind::png);
  EXPECT_EQ(file_kind("b.bmp"), FileKind::bmp);
  EXPECT_EQ(file_kind("b.mhd"), FileKind::meta_image);
  EXPECT_EQ(file_kind("b.Stl"), FileKind::stl);
  EXPECT_FALSE(file_kind(".stl"));
  EXPECT_FALSE(file_kind("a/b.raw.gz"));
  EXPECT_FALSE(file_kind("a.raw/b"));
  EXPECT_FALSE(file_kind(""));
}

TEST(FileKind, IsWrittenAsOneFileOnly) {
  for (const char* name :
       {"a.raw", "a.NRRD", "a.vdb", "a.nii", "a.nii.GZ", "a.mha", "a.npy", "a.vti"})
    EXPECT_TRUE(is_written(name)) << name;
  for (const char* name :
       {"a.nhdr", "a.hdr", "a.mhd", "a.nrrd.gz", "a.tif", "a.stl", "a.txt", "nrrd", ""})
    EXPECT_FALSE(is_written(name)) << name;
}

TEST(FileFormats, AreOneForEachKindWithExtensionsOfTheirOwn) {
  std::set<FileKind> kinds;
  std::set<std::string_view> extensions;
  for (const FileFormat& format : file_formats()) {
    EXPECT_TRUE(kinds.insert(format.kind).second) << format.name;
    for (const std::string_view extension : format.extensions) {
      if (extension.empty()) continue;
      EXPECT_TRUE(extensions.insert(extension).second) << extension;
      EXPECT_EQ(file_format("a" + std::string(extension)), &format) << extension;
    }
  }
}

TEST(FileFormats, ListsNameEveryExtension) {
  EXPECT_EQ(written_extensions(), ".raw, .nii, .nii.gz, .nrrd, .mha, .npy, .vti or .vdb");
  EXPECT_EQ(mesh_extensions(), ".stl, .ply, .obj and .off");
  for (const FileFormat& format : file_formats()) {
    const std::string list = format.is_mesh ? mesh_extensions() : supported_extensions();
    for (const std::string_view extension : format.extensions)
      EXPECT_NE(list.find(extension), std::string::npos) << extension;
  }
}

TEST(FileFormats, ExtensionsKeepThatOfPackedFiles) {
  EXPECT_EQ(extension_of("a/b.NII.gz"), ".nii.gz");
  EXPECT_EQ(extension_of("a.b/c.Raw"), ".raw");
}

}  // namespace
}  // namespace isoloop
