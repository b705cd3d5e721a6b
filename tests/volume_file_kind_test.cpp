#include <gtest/gtest.h>

#include "volume/file_kind.h"

namespace isoloop {
namespace {

TEST(FileKind, GoesByTheExtensionWhateverItsCase) {
  EXPECT_EQ(file_kind("a/b.raw"), FileKind::raw);
  EXPECT_EQ(file_kind("a/b.VDB"), FileKind::vdb);
  EXPECT_FALSE(file_kind("a/b.stl"));
  EXPECT_FALSE(file_kind("a.raw/b"));
  EXPECT_FALSE(file_kind(""));
}

}  // namespace
}  // namespace isoloop
