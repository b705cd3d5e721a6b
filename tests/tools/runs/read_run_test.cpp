#include "tools/runs/read_run.h"

#include <string>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/scratch_directory.h"

namespace isoloop {
namespace {

VolumeFlags raw_flags(const std::string& file, const std::string& dims) {
  VolumeFlags flags;
  flags.file = file;
  flags.dims = dims;
  flags.type = "u8";
  flags.spacing = "0.5";
  return flags;
}

TEST(ReadRun, SettlesVolumeRangeAndLevel) {
  const ScratchDirectory scratch;
  scratch.write("x.raw", std::string("\1\2\3\4", 4));
  const std::string file = (scratch.path() / "x.raw").string();
  const RunInput run = read_run(raw_flags(file, "2 2 1"), {.iso = "2.5", .inside = "below"});
  EXPECT_EQ(run.file, file);
  EXPECT_EQ(run.volume.dims, (Index3{2, 2, 1}));
  EXPECT_EQ(run.volume.spacing, (Vec3{0.5, 0.5, 0.5}));
  EXPECT_EQ(run.range.min, 1.0);
  EXPECT_EQ(run.range.max, 4.0);
  EXPECT_EQ(run.level.iso, 2.5);
  EXPECT_EQ(run.level.inside, InsideRule::below);
  EXPECT_GT(run.cost.read_seconds, 0.0);
}

TEST(ReadRun, RefusesAFlagBeforeItReads) {
  EXPECT_THROW(read_run(raw_flags("/no/such/file.raw", "2 2"), {}), InvalidArgument);
  EXPECT_THROW(read_run(raw_flags("/no/such/file.raw", "2 2 2"), {}), InvalidInput);
}

}  // namespace
}  // namespace isoloop
