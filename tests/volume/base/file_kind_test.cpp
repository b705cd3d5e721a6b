#include "volume/base/file_kind.h"

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
  EXPECT_FALSE(file_kind("a/b.raw.gz"));
  EXPECT_FALSE(file_kind("a/b.stl"));
  EXPECT_FALSE(file_kind("a.raw/b"));
  EXPECT_FALSE(file_kind(""));
}

TEST(FileKind, IsWrittenAsOneFileOnly) {
  for (const char* name : {"a.raw", "a.NRRD", "a.vdb"}) EXPECT_TRUE(is_written(name)) << name;
  for (const char* name : {"a.nhdr", "a.nii", "a.npy", "a.txt", "nrrd", ""})
    EXPECT_FALSE(is_written(name)) << name;
}

}  // namespace
}  // namespace isoloop
