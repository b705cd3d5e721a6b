#include "tools/bench/bench_run.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

using Words = std::vector<std::string>;

Measurement measured(double seconds, std::int64_t size = 64) {
  const std::vector<StageCost> stages{{"surface", 1.0, 1.0, 10}, {"loops", seconds, seconds, 20}};
  return {.dims = {size, 2, 2},
          .triangles = 100,
          .genus = 1,
          .loops = 2,
          .slowest_loops_seconds = seconds / 2,
          .whole = whole_of(stages),
          .stages = stages};
}

ProcessEnd done(double seconds, std::int64_t size = 64) {
  return {.exit_code = 0, .out = text_of(measured(seconds, size)) + "\n"};
}

BenchPlan plan_of(std::vector<BenchCase> cases, std::vector<int> threads, int repeat) {
  return {.cases = std::move(cases), .threads = std::move(threads), .repeat = repeat};
}

TEST(Bench, RunsEveryCaseOnEveryNumberOfThreadsAsOftenAsAsked) {
  std::multiset<std::string> started;
  const BenchPlan plan =
      plan_of({{"a", 64, {"measure", "--shape=a"}}, {"b.raw", 0, {"measure"}}}, {1, 4}, 2);
  const BenchRun run = bench(plan,
                             [&](const Words& words, double) {
                               std::string text;
                               for (const std::string& word : words) text += word + " ";
                               started.insert(text);
                               return done(1.0);
                             },
                             {});
  EXPECT_EQ(started, (std::multiset<std::string>{
                         "measure --shape=a --threads=1 ", "measure --shape=a --threads=1 ",
                         "measure --shape=a --threads=4 ", "measure --shape=a --threads=4 ",
                         "measure --threads=1 ", "measure --threads=1 ", "measure --threads=4 ",
                         "measure --threads=4 "}));
  ASSERT_EQ(run.rows.size(), 4U);
  EXPECT_EQ(run.rows[1].volume, "a");
  EXPECT_EQ(run.rows[1].threads, 4);
  EXPECT_EQ(run.rows[2].size, 64) << "of what was read";
}

TEST(Bench, ReportsTheMedianOfEachFigureByItself) {
  std::vector<double> seconds{5.0, 1.0, 2.0};
  const BenchRun run = bench(plan_of({{"a", 64, {}}}, {1}, 3),
                             [&](const Words&, double) {
                               const double next = seconds.back();
                               seconds.pop_back();
                               return done(next);
                             },
                             {});
  EXPECT_EQ(run.rows.at(0).median.stages.at(1).cpu_seconds, 2.0);
  EXPECT_EQ(run.rows.at(0).median.whole.wall_seconds, 3.0);
  EXPECT_EQ(run.rows.at(0).median.slowest_loops_seconds, 1.0);
  EXPECT_EQ(median_of({measured(1.0), measured(4.0)}).stages.at(1).cpu_seconds, 2.5);
}

TEST(Bench, ARunThatFailsIsARowAndNotTheEnd) {
  int runs_of_b = 0;
  const BenchPlan plan = plan_of({{"a", 64, {"a"}}, {"b", 64, {"b"}}, {"c", 64, {"c"}}}, {1}, 3);
  const BenchRun run =
      bench(plan,
            [&](const Words& words, double) -> ProcessEnd {
              if (words[0] != "b") return done(1.0);
              ++runs_of_b;
              return {.exit_code = 4, .err = "isoloop: warning: odd\nisoloop: too much memory\n"};
            },
            {});
  ASSERT_EQ(run.rows.size(), 3U);
  EXPECT_EQ(run.rows[0].failure, "");
  EXPECT_EQ(run.rows[1].failure, "too much memory");
  EXPECT_EQ(run.rows[1].exit_code, 4);
  EXPECT_EQ(run.rows[2].failure, "");
  EXPECT_EQ(runs_of_b, 1) << "it would fail again";
}

TEST(Bench, SaysWhatEndedARunThatCouldNotSayItself) {
  const auto failure = [](const ProcessEnd& end) {
    BenchPlan plan = plan_of({{"a", 64, {}}}, {1}, 1);
    plan.max_seconds = 1.5;
    return bench(plan, [&](const Words&, double) { return end; }, {}).rows.at(0).failure;
  };
  EXPECT_EQ(failure({.exit_code = 137, .out_of_time = true}), "not done after 1.5 s");
  EXPECT_EQ(failure({.exit_code = 137}),
            "ended by signal 9, as where the system runs out of memory");
  EXPECT_EQ(failure({.exit_code = 139, .err = "isoloop: warning: x\n"}), "ended by signal 11");
  EXPECT_EQ(failure({.exit_code = 3}), "ended with exit code 3");
}

TEST(Bench, PutsTheRunsTogether) {
  const std::vector<BenchCase> cases{{"a", 64, {"64"}}, {"a", 128, {"128"}}};
  const BenchRun run = bench(plan_of(cases, {1, 2}, 1),
                             [](const Words& words, double) {
                               const double seconds = words[1] == "--threads=1" ? 8.0 : 4.0;
                               return done(seconds, std::stoi(words[0]));
                             },
                             {});
  EXPECT_EQ(run.growth.size(), 2U);
  EXPECT_EQ(run.efficiency.size(), 2U);
  EXPECT_GT(run.machine.cores, 0);
}

TEST(Bench, TellsHowFarItHasComeByVoxels) {
  std::vector<double> shares;
  bench(
      plan_of({{"a", 1, {}}, {"a", 2, {}}}, {1}, 1), [](const Words&, double) { return done(1.0); },
      [&](const char* stage, double share) {
        EXPECT_NE(std::string(stage).find("a "), std::string::npos);
        shares.push_back(share);
      });
  EXPECT_EQ(shares, (std::vector<double>{0.0, 1.0 / 9.0}));
}

}  // namespace
}  // namespace isoloop
