#include "tools/bench/measurement.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

std::vector<std::string> names_of(const Measurement& measurement) {
  std::vector<std::string> names;
  for (const StageCost& stage : measurement.stages) names.push_back(stage.name);
  return names;
}

TEST(Measurement, OfAShapeHasItsCountsAndEveryStageButReading) {
  const Measurement measured = measure_shape("torus", {.size = 32}, {});
  EXPECT_EQ(measured.genus, 1);
  EXPECT_EQ(measured.loops, 2);
  EXPECT_GT(measured.triangles, 1000);
  EXPECT_EQ(names_of(measured),
            (std::vector<std::string>{"surface", "closest", "sizes", "pass", "loops", "checks"}));
  EXPECT_GT(measured.slowest_loops_seconds, 0.0);
  EXPECT_LE(measured.slowest_loops_seconds, measured.whole.cpu_seconds);
  EXPECT_GE(measured.whole.peak_bytes,
            sizeof(float) * static_cast<std::uint64_t>(voxels_of(measured)));
}

TEST(Measurement, OfAShapeWithoutLoopsEndsWithItsSurface) {
  EXPECT_EQ(names_of(measure_shape("ball", {.size = 32}, {})),
            (std::vector<std::string>{"surface", "checks"}));
}

TEST(Measurement, RefusesAShapeThatIsTooSmall) {
  EXPECT_THROW(measure_shape("engine_block", {.size = 32}, {}), InvalidArgument);
}

TEST(Measurement, ReadsBackAsItWasWritten) {
  const Measurement measured = measure_shape("torus", {.size = 32}, {});
  const Measurement read = measurement_of(text_of(measured));
  EXPECT_EQ(text_of(read), text_of(measured));
  EXPECT_EQ(names_of(read), names_of(measured));
  EXPECT_EQ(read.whole.peak_bytes, measured.whole.peak_bytes);
  EXPECT_EQ(voxels_of(read), voxels_of(measured));
}

TEST(Measurement, RefusesATextThatIsNone) {
  for (const char* text : {"", "{}", "[1]", "{\"dims\": 3}"})
    EXPECT_THROW(measurement_of(text), SelfCheckFailed) << text;
}

}  // namespace
}  // namespace isoloop
