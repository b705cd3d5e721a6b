#include "tools/bench/bench_flags.h"

#include <algorithm>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

using Words = std::vector<std::string>;

BenchPlan planned(Words words) {
  CLI::App app;
  BenchFlags flags;
  add_bench_flags(app, flags);
  std::reverse(words.begin(), words.end());
  app.parse(words);
  return plan_of(flags, app, 4);
}

/// By the errors that the command line turns into sentences.
bool is_refused(const Words& words) {
  try {
    planned(words);
  } catch (const CLI::ParseError&) {
    return true;
  } catch (const InvalidArgument&) {
    return true;
  }
  return false;
}

TEST(BenchFlags, AskForAHandfulOfShapesByThemselves) {
  const BenchPlan plan = planned({});
  EXPECT_EQ(plan.cases.size(), 15U);  // five at 64, 128 and 256
  EXPECT_EQ(plan.threads, (std::vector<int>{1, 4}));
  EXPECT_EQ(plan.repeat, 1);
  EXPECT_EQ(plan.cases[0].volume, "torus");
  EXPECT_EQ(plan.cases[0].size, 64);
  EXPECT_EQ(plan.cases[0].arguments, (Words{"measure", "--shape=torus", "--size=64"}));
}

TEST(BenchFlags, HandWhatIsOfEveryRunToAllAndWhatIsOfAFileToTheFile) {
  const BenchPlan plan =
      planned({"--shapes", "lattice:7,torus,torus", "--sizes", "96,64,96", "--file", "a b.raw",
               "--iso=70 90", "--tighten", "none", "--open-boundary", "--max-memory", "2G"});
  ASSERT_EQ(plan.cases.size(), 5U);
  EXPECT_EQ(plan.cases[1].size, 96);
  EXPECT_EQ(plan.cases[1].arguments, (Words{"measure", "--shape=lattice:7", "--size=96",
                                            "--max-memory=2G", "--tighten=none"}));
  EXPECT_EQ(plan.cases[4].volume, "a b.raw");
  EXPECT_EQ(plan.cases[4].arguments,
            (Words{"measure", "--file=a b.raw", "--iso=70 90", "--open-boundary=true",
                   "--max-memory=2G", "--tighten=none"}));
}

TEST(BenchFlags, AFileAloneIsTheOnlyCase) {
  EXPECT_EQ(planned({"--file", "a.raw", "--iso", "70"}).cases.size(), 1U);
}

TEST(BenchFlags, RefuseWhatMeansNothing) {
  const std::vector<Words> all{{"--iso", "70"},           {"--file", "a.raw", "--sizes", "64"},
                               {"--sizes", "64,x"},       {"--sizes", "0"},
                               {"--threads", "0"},        {"--threads", "1,some"},
                               {"--threads", ""},         {"--shapes", "torus,donut"},
                               {"--shapes", "torus:3"},   {"--shapes", "lattice:x"},
                               {"--shapes", "lattice:0"}, {"--refine", "1"}};
  for (const Words& words : all) EXPECT_TRUE(is_refused(words)) << words.back();
}

TEST(BenchFlags, ReadThreadsInOrderAndOnce) {
  EXPECT_EQ(parse_threads("all,2,1", 2), (std::vector<int>{1, 2}));
  EXPECT_EQ(parse_threads("16", 2), (std::vector<int>{16}));
  EXPECT_THROW(parse_threads("1,,2", 2), InvalidArgument);
}

TEST(BenchFlags, ReadTheNumberOfAShape) {
  EXPECT_EQ(parse_shape("lattice:7").options.cells, 7);
  EXPECT_EQ(parse_shape("plate:12").options.holes, 12);
  EXPECT_EQ(parse_shape("trefoil").name, "trefoil");
}

}  // namespace
}  // namespace isoloop
