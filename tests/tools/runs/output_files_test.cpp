#include "tools/runs/output_files.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/scratch_directory.h"

namespace isoloop {
namespace {

void write_name(std::ostream& out) { out << "torus.raw"; }
void fail(std::ostream&) { throw LimitExceeded("too many vertices"); }

TEST(OutputFiles, LeavesNothingBeforeItWrites) {
  const ScratchDirectory scratch;
  OutputFiles outputs("in.raw");
  outputs.add("--json", (scratch.path() / "a").string(), write_name);
  EXPECT_TRUE(scratch.files().empty());
  outputs.write();
  EXPECT_EQ(scratch.read("a"), "torus.raw");
}

TEST(OutputFiles, ReportsTellOfTheRunAsItIsWhenTheyAreWritten) {
  const ScratchDirectory scratch;
  OutputFiles outputs("in.raw");
  int run = 1;
  const auto write = [](std::ostream& out, const int& result) { out << result; };
  outputs.add("--json", (scratch.path() / "a").string(), report_of(run, write));
  run = 2;
  outputs.write();
  EXPECT_EQ(scratch.read("a"), "2");
}

TEST(OutputFiles, WritesNoneIfOneReportFails) {
  const ScratchDirectory scratch;
  scratch.write("a", "old");
  OutputFiles outputs("in.raw");
  outputs.add("--json", (scratch.path() / "a").string(), write_name);
  outputs.add("--ply", (scratch.path() / "b").string(), fail);
  EXPECT_THROW(outputs.write(), LimitExceeded);
  EXPECT_EQ(scratch.files(), std::vector<std::string>{"a"});
  EXPECT_EQ(scratch.read("a"), "old");
}

TEST(OutputFiles, RefusesTheInputUnderAnyName) {
  const ScratchDirectory scratch;
  scratch.write("in.raw", "voxels");
  std::filesystem::create_symlink(scratch.path() / "in.raw", scratch.path() / "link");
  OutputFiles outputs(scratch.path() / "in.raw");
  EXPECT_THROW(outputs.add("--ply", (scratch.path() / "." / "in.raw").string(), write_name),
               InvalidArgument);
  EXPECT_THROW(outputs.add("--ply", (scratch.path() / "link").string(), write_name),
               InvalidArgument);
}

TEST(OutputFiles, RefusesTheSlicesOfAFolderAndVoxelsBesideAHeader) {
  const ScratchDirectory scratch;
  scratch.write("1.png", "slice");
  OutputFiles of_folder(scratch.path());
  EXPECT_THROW(of_folder.add("--ply", (scratch.path() / "1.png").string(), write_name),
               InvalidArgument);
  EXPECT_NO_THROW(of_folder.add("--ply", (scratch.path() / "new.ply").string(), write_name));
  OutputFiles of_header(scratch.path() / "a.nhdr");
  of_header.add("--json", (scratch.path() / "1.png").string(), write_name);
  EXPECT_NO_THROW(of_header.check_apart_from({}));
  EXPECT_NO_THROW(of_header.check_apart_from(scratch.path() / "a.raw"));
  EXPECT_THROW(of_header.check_apart_from(scratch.path() / "." / "1.png"), InvalidArgument);
}

TEST(OutputFiles, RefusesOneFileTwice) {
  const ScratchDirectory scratch;
  OutputFiles outputs("in.raw");
  outputs.add("--json", "-", write_name);
  EXPECT_THROW(outputs.add("--csv", "-", write_name), InvalidArgument);
  outputs.add("--csv", (scratch.path() / "a").string(), write_name);
  EXPECT_THROW(outputs.add("--ply", (scratch.path() / "a").string(), write_name), InvalidArgument);
  EXPECT_TRUE(outputs.uses_stdout());
}

TEST(OutputFiles, RefusesAFlagForAName) {
  OutputFiles outputs("in.raw");
  EXPECT_THROW(outputs.add("--json", "--ply", write_name), InvalidArgument);
}

TEST(OutputFiles, RefusesAFolderThatDoesNotExist) {
  OutputFiles outputs("in.raw");
  EXPECT_THROW(outputs.add("--json", "/no/such/folder/a", write_name), InvalidInput);
}

}  // namespace
}  // namespace isoloop
