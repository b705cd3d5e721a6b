#include "tools/bench/growth.h"

#include <cmath>
#include <deque>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

/// Runs whose figures are made up; not to be moved.
struct Runs {
  void add(const std::string& volume, std::int64_t size, int threads,
           const std::vector<StageCost>& stages) {
    measured.push_back({.dims = {size, size, size}, .whole = whole_of(stages), .stages = stages});
    runs.push_back({volume, size, threads, &measured.back()});
  }

  std::deque<Measurement> measured;
  std::vector<MeasuredRun> runs;
};

std::optional<double> of(const ByStage& figures, const std::string& name) {
  for (const auto& [stage, figure] : figures)
    if (stage == name) return figure;
  return std::nullopt;
}

/// CPU time of the stage loops grows as voxels^exponent.
void add_sizes(Runs& runs, const std::string& volume, double exponent) {
  for (const std::int64_t size : {32, 64, 128}) {
    const auto voxels = static_cast<double>(size * size * size);
    const double seconds = 1e-4 * std::pow(voxels, exponent);
    runs.add(volume, size, 1, {{"pass", 1.0, 1.0, 100}, {"loops", seconds, 2.0 * seconds, 8000}});
  }
}

TEST(Growth, IsTheSlopeOverVoxelsForEachVolumeByItself) {
  Runs runs;
  add_sizes(runs, "torus", 1.25);
  add_sizes(runs, "lattice", 0.75);
  const std::vector<Growth> growth = growth_of(runs.runs);
  ASSERT_EQ(growth.size(), 2U);
  EXPECT_EQ(growth[0].volume, "torus");
  EXPECT_EQ(growth[0].least_size, 32);
  EXPECT_EQ(growth[0].largest_size, 128);
  EXPECT_NEAR(of(growth[0].cpu, "loops").value(), 1.25, 1e-12);
  EXPECT_NEAR(of(growth[1].cpu, "loops").value(), 0.75, 1e-12);
  EXPECT_NEAR(of(growth[0].cpu, "pass").value(), 0.0, 1e-12);
  EXPECT_NEAR(growth[0].peak.value(), 0.0, 1e-12);
  EXPECT_GT(growth[0].wall.value(), 0.5);
}

TEST(Growth, NeedsTwoSizesAndTimesThatCanBeTold) {
  Runs runs;
  runs.add("torus", 32, 1, {{"loops", 1.0, 1.0, 1}});
  EXPECT_TRUE(growth_of(runs.runs).empty());
  runs.add("torus", 32, 2, {{"loops", 1.0, 1.0, 1}});  // on other threads: another line
  EXPECT_TRUE(growth_of(runs.runs).empty());
  runs.add("torus", 64, 1, {{"loops", 1e-4, 1.0, 1}, {"checks", 1.0, 1.0, 1}});
  const std::vector<Growth> growth = growth_of(runs.runs);
  ASSERT_EQ(growth.size(), 1U);
  EXPECT_FALSE(of(growth[0].cpu, "loops"));
  EXPECT_FALSE(of(growth[0].cpu, "checks"));
  EXPECT_TRUE(of(growth[0].cpu, "all"));
}

TEST(Efficiency, ComparesWithTheLeastThreadsOfTheSameCase) {
  Runs runs;
  runs.add("torus", 64, 2, {{"pass", 4.0, 3.0, 1}, {"loops", 4.0, 1.0, 1}});
  runs.add("torus", 32, 1, {{"pass", 9.0, 9.0, 1}});
  runs.add("torus", 64, 8, {{"pass", 4.0, 1.5, 1}, {"loops", 4.0, 0.5, 1}});
  const std::vector<Efficiency> efficiency = efficiency_of(runs.runs);
  ASSERT_EQ(efficiency.size(), 1U);
  EXPECT_EQ(efficiency[0].threads, 8);
  EXPECT_EQ(efficiency[0].least_threads, 2);
  EXPECT_DOUBLE_EQ(efficiency[0].speedup, 2.0);
  EXPECT_DOUBLE_EQ(of(efficiency[0].efficiency, "all").value(), 0.5);
  EXPECT_DOUBLE_EQ(of(efficiency[0].efficiency, "loops").value(), 0.5);
}

TEST(Growth, NamesStagesInTheirOrderThoughSomeRunsLackThem) {
  Runs runs;
  runs.add("ball", 32, 1, {{"surface", 1.0, 1.0, 1}, {"checks", 1.0, 1.0, 1}});
  runs.add("a.raw", 32, 1,
           {{"read", 1, 1, 1}, {"surface", 1, 1, 1}, {"loops", 1, 1, 1}, {"checks", 1, 1, 1}});
  EXPECT_EQ(stage_names(runs.runs),
            (std::vector<std::string>{"all", "read", "surface", "loops", "checks"}));
}

}  // namespace
}  // namespace isoloop
