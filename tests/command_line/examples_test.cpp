// The programs of examples/, as a reader would try them.
#include <gtest/gtest.h>

#include "tests/samples/run_process.h"
#include "tests/samples/scratch_directory.h"

namespace isoloop {
namespace {

ProcessResult run_example(const ScratchDirectory& scratch, const std::string& name,
                          const std::vector<std::string>& arguments) {
  return run_program(ISOLOOP_EXAMPLES "/isoloop_example_" + name, scratch.path(), arguments);
}

void generate(const ScratchDirectory& scratch, const std::string& shape) {
  ASSERT_EQ(run_isoloop(scratch.path(), {"generate", shape, "--size", "48", "-o", shape + ".vdb"})
                .exit_code,
            0);
}

TEST(Examples, CountNeedsNoFile) {
  const ScratchDirectory scratch;
  const ProcessResult result = run_example(scratch, "count", {});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(result.out.starts_with("1 components, 2 tunnels, 0 cavities\n")) << result.out;
  EXPECT_TRUE(result.out.ends_with("triangles of genus 2\n")) << result.out;
}

TEST(Examples, LoopsSaysWhereToCutAndFillATorus) {
  const ScratchDirectory scratch;
  generate(scratch, "torus");
  const ProcessResult result = run_example(scratch, "loops", {"torus.vdb"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(result.out.starts_with("1 components, 1 tunnels, 0 cavities\nhandle loop, cut at "))
      << result.out;
  EXPECT_NE(result.out.find("\ntunnel loop, fill at "), std::string::npos) << result.out;
  EXPECT_EQ(run_example(scratch, "loops", {"none.vdb"}).exit_code, 3);
  EXPECT_EQ(run_example(scratch, "loops", {}).exit_code, 2);
}

TEST(Examples, RepairFillsTheHolesOfAPlate) {
  const ScratchDirectory scratch;
  generate(scratch, "plate");
  const ProcessResult result = run_example(scratch, "repair", {"plate.vdb", "1000", "out.nrrd"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("3 tunnels before, 0 after\n"), std::string::npos) << result.out;
  const ProcessResult count =
      run_isoloop(scratch.path(), {"count", "out.nrrd", "--iso", "0", "--inside", "below"});
  EXPECT_NE(count.out.find("tunnels     0"), std::string::npos) << count.out;
}

TEST(Examples, ScanGoesOnAfterAFileThatItCannotRead) {
  const ScratchDirectory scratch;
  generate(scratch, "shell");
  const ProcessResult result = run_example(scratch, "scan", {"none.vdb", "shell.vdb"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("none.vdb"), std::string::npos) << result.err;
  EXPECT_TRUE(result.out.starts_with("shell.vdb: ")) << result.out;
  EXPECT_NE(result.out.find(" components, "), std::string::npos) << result.out;
}

}  // namespace
}  // namespace isoloop
