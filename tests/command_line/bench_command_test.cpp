// `isoloop bench` as a user runs it.
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/command_line/fixture.h"

namespace isoloop {
namespace {

using Bench = CommandLine;

Json stage_of(const Json& run, const std::string& name) {
  for (const Json& stage : run.at("stages"))
    if (stage.at("stage") == name) return stage;
  return {};
}

TEST_F(Bench, MeasuresShapesAndAFileInOneTable) {
  std::ofstream(scratch_.path() / "ring_5x5x3_uint8.raw", std::ios::binary) << ring_bytes();
  const ProcessResult result =
      run({"bench", "--shapes", "torus", "--sizes", "24,32", "--threads", "1,2", "--file",
           "ring_5x5x3_uint8.raw", "--iso", "0.5", "--json", "bench.json", "--csv", "bench.csv",
           "--svg", "bench.svg"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("\ngrowth: "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("\nparallel efficiency: "), std::string::npos) << result.out;
  const Json json = Json::parse(scratch_.read("bench.json"));
  ASSERT_EQ(json.at("runs").size(), 6U);
  const Json& torus = json.at("runs").at(2);
  EXPECT_EQ(torus.at("size"), 32);
  EXPECT_EQ(torus.at("genus"), 1);
  const Json& ring = json.at("runs").at(5);
  EXPECT_EQ(ring.at("volume"), "ring_5x5x3_uint8.raw");
  EXPECT_EQ(ring.at("dims"), Json({5, 5, 3}));
  EXPECT_EQ(ring.at("loops"), 2);
  EXPECT_EQ(stage_of(ring, "read").at("stage"), "read");
  EXPECT_TRUE(stage_of(torus, "read").is_null()) << "a shape is not read";
}

TEST_F(Bench, MeasuresTheMemoryOfEachRunByItself) {
  // The small one comes after the large one, whose peak a single process would keep.
  const ProcessResult result =
      run({"bench", "--shapes", "lattice,torus", "--sizes", "96", "--threads", "1", "--json", "-"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json runs = Json::parse(result.out).at("runs");
  const auto large = stage_of(runs.at(0), "all").at("peak_bytes").get<double>();
  const auto small = stage_of(runs.at(1), "all").at("peak_bytes").get<double>();
  EXPECT_LT(small, 0.8 * large);
}

TEST_F(Bench, ACaseThatFailsIsARowOfItsOwn) {
  const ProcessResult result =
      run({"bench", "--shapes", "engine_block,torus", "--sizes", "32", "--threads", "1"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("take 103 or more"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("torus"), std::string::npos) << result.out;
}

TEST_F(Bench, WhereMemoryOrTimeEndsTheRowSaysSo) {
  const ProcessResult memory = run({"bench", "--shapes", "ball,lattice", "--sizes", "96",
                                    "--threads", "1", "--max-memory", "60M"});
  EXPECT_EQ(memory.exit_code, 0) << memory.err;
  EXPECT_NE(memory.out.find("memory"), std::string::npos) << memory.out;
  const ProcessResult time = run({"bench", "--shapes", "ball,lattice:7", "--sizes", "32,256",
                                  "--threads", "1", "--max-seconds", "3"});
  EXPECT_EQ(time.exit_code, 0) << time.err;
  EXPECT_NE(time.out.find("not done after 3 s"), std::string::npos) << time.out;
}

TEST_F(Bench, WhereNothingIsMeasuredItFailsAsTheRunDid) {
  std::ofstream(scratch_.path() / "odd.raw") << "odd";
  expect_failure({"bench", "--file", "odd.raw", "--iso", "3"}, 2, "--dims");
  expect_failure({"bench", "--file", "none.vdb", "--iso", "3"}, 3, "none.vdb");
  expect_failure({"bench", "--shapes", "lattice", "--sizes", "96", "--max-memory", "1M"}, 4, "");
}

TEST_F(Bench, RefusesFlagsThatMeanNothingBeforeAnythingRuns) {
  expect_failure({"bench", "--iso", "3"}, 2, "--iso means nothing without --file");
  expect_failure({"bench", "--shapes", "donut"}, 2, "donut");
  expect_failure({"bench", "--threads", "0"}, 2, "--threads");
  expect_failure({"bench", "--json", "no/where.json"}, 3, "no/where.json");
}

}  // namespace
}  // namespace isoloop
