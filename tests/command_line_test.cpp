// Promises of the command line, kept by the built executable.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/run_process.h"
#include "tests/scratch_directory.h"

namespace isoloop {
namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

std::string float_bytes(const std::vector<float>& values) {
  std::string bytes;
  for (const float value : values) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8) {
      bytes.push_back(static_cast<char>((bits >> shift) & 0xFF));
    }
  }
  return bytes;
}

// A ring of ones, one voxel thick, in a 5 x 5 x 3 box of zeros: one component, one tunnel.
std::string ring_bytes() {
  std::string bytes(75, '\0');
  for (const std::size_t place : {6, 7, 8, 11, 13, 16, 17, 18}) bytes[25 + place] = '\1';
  return bytes;
}

class CommandLine : public testing::Test {
 protected:
  ProcessResult run(const Words& arguments) const {
    return run_isoloop(scratch_.path(), arguments);
  }

  // The run failed with this code and one sentence that holds `words`, and wrote nothing.
  void expect_failure(const Words& arguments, int code, const std::string& words) const {
    const Words before = scratch_.files();
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(result.err.starts_with("isoloop: ")) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_EQ(scratch_.files(), before);
  }

  ScratchDirectory scratch_;
};

TEST_F(CommandLine, HelpShowsThreeExamplesAndSucceeds) {
  const std::regex example("\n  isoloop [a-z]+ ");
  for (const Words& arguments : {Words{"-h"}, Words{"info", "-h"}, Words{"count", "-h"},
                                 Words{"loops", "-h"}, Words{"generate", "--help"}}) {
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << arguments[0];
    EXPECT_EQ(result.err, "");
    const std::string examples = result.out.substr(result.out.find("Examples:"));
    const auto first = std::sregex_iterator(examples.begin(), examples.end(), example);
    EXPECT_EQ(std::distance(first, std::sregex_iterator()), 3) << arguments[0];
  }
}

TEST_F(CommandLine, VersionGoesToStandardOutput) {
  const ProcessResult result = run({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.out.starts_with("isoloop ")) << result.out;
}

TEST_F(CommandLine, NoCommandIsAUsageError) { expect_failure({}, 2, "isoloop -h"); }

TEST_F(CommandLine, UnknownCommandIsAUsageErrorThatNamesTheCommands) {
  expect_failure({"lops", "x.raw"}, 2, "lops is no command");
  expect_failure({"lops", "x.raw"}, 2, "loops");
}

TEST_F(CommandLine, UnknownFlagIsAUsageError) {
  expect_failure({"loops", "x.raw", "--isso", "3"}, 2, "--isso");
}

TEST_F(CommandLine, MissingFileIsUnreadableInput) {
  const std::string name = "none_4x4x4_uint8.raw";
  expect_failure({"info", name}, 3, name);
  expect_failure({"count", name, "--iso", "1", "--json", "a.json"}, 3, name);
  expect_failure({"loops", name, "--iso", "1", "--ply", "a.ply", "--csv", "a.csv"}, 3, name);
}

TEST_F(CommandLine, WrongDimsAreUnreadableInput) {
  scratch_.write("ring.raw", ring_bytes());
  expect_failure({"count", "ring.raw", "--dims", "5", "5", "4", "--type", "u8", "--iso", "1"}, 3,
                 "ring.raw");
}

TEST_F(CommandLine, DimsThatAreNoDimsAreAUsageError) {
  scratch_.write("ring.raw", ring_bytes());
  expect_failure({"count", "ring.raw", "--dims", "5x5", "--type", "u8", "--iso", "1"}, 2, "--dims");
  expect_failure({"count", "ring.raw", "--dims", "5x5x0", "--type", "u8", "--iso", "1"}, 2,
                 "--dims");
  expect_failure({"count", "ring.raw", "--dims", "--type", "u8", "--iso", "1"}, 2, "--dims");
  expect_failure({"count", "ring.raw", "--type", "u8", "--iso", "1"}, 2, "--dims");
}

TEST_F(CommandLine, ShortRawFileIsUnreadableInput) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes().substr(1));
  expect_failure({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--json", "a.json"}, 3, "74");
}

TEST_F(CommandLine, NanIsRefusedUnlessAValueStandsIn) {
  std::vector<float> values(27, 0.0F);
  values[13] = std::numeric_limits<float>::quiet_NaN();
  scratch_.write("x_3x3x3_float32.raw", float_bytes(values));
  expect_failure({"count", "x_3x3x3_float32.raw", "--iso", "0.5"}, 3, "--nan-as");
  const ProcessResult result =
      run({"count", "x_3x3x3_float32.raw", "--iso", "0.5", "--nan-as", "1", "--json", "-"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Json::parse(result.out).at("betti").at("b0"), 1);
}

TEST_F(CommandLine, TopologySaysWhetherATunnelWithinACubeJoinsItsCorners) {
  scratch_.write("cube_2x2x2_float32.raw", float_bytes({4, -1, -1, -1, -1, -1, -1, 4}));
  const auto components = [&](const Words& flags) {
    Words arguments{"count", "cube_2x2x2_float32.raw", "--iso", "0", "--json", "-"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    return Json::parse(run(arguments).out).at("betti").at("b0").get<int>();
  };
  EXPECT_EQ(components({}), 1);
  EXPECT_EQ(components({"--topology", "trilinear"}), 1);
  EXPECT_EQ(components({"--topology", "simple"}), 2);
  expect_failure({"count", "cube_2x2x2_float32.raw", "--iso", "0", "--topology", "cubic"}, 2,
                 "--topology");
}

TEST_F(CommandLine, MissingIsoIsAUsageErrorThatStatesTheRange) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  expect_failure({"loops", "ring_5x5x3_uint8.raw"}, 2, "0 to 1");
}

TEST_F(CommandLine, IsoThatIsNoNumberIsAUsageError) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  for (const char* iso : {"five", "nan", "inf", ""}) {
    expect_failure({"loops", "ring_5x5x3_uint8.raw", "--iso", iso}, 2, "--iso");
  }
}

TEST_F(CommandLine, OutputInAMissingDirectoryFailsBeforeReading) {
  for (const char* flag : {"--json", "--csv", "--ply"}) {
    expect_failure({"loops", "unread_5x5x3_uint8.raw", "--iso", "1", flag, "none/x"}, 3, "none/x");
  }
  expect_failure({"generate", "torus", "--size", "40", "-o", "none/x.raw"}, 3, "none/x.raw");
}

TEST_F(CommandLine, OutputNeverReplacesItsInputOrAnotherOutput) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  expect_failure(
      {"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--json", "./ring_5x5x3_uint8.raw"}, 2,
      "--json");
  expect_failure({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--json", "a", "--csv", "./a"}, 2,
                 "--csv");
  EXPECT_EQ(scratch_.read("ring_5x5x3_uint8.raw"), ring_bytes());
}

TEST_F(CommandLine, FileOverTheMemoryLimitIsRefused) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  expect_failure({"count", "ring_5x5x3_uint8.raw", "--iso", "1", "--max-memory", "50"}, 4,
                 "--max-memory");
}

TEST_F(CommandLine, AnalysisOverTheMemoryLimitIsRefused) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer ends the process where memory runs out";
#endif
  if (std::thread::hardware_concurrency() > 8) GTEST_SKIP() << "room for stacks hides the limit";
  ASSERT_EQ(run({"generate", "lattice", "--size", "96", "-o", "g.raw"}).exit_code, 0);
  expect_failure({"loops", "g.raw", "--dims", "96x96x96", "--type", "f32", "--iso", "0",
                  "--max-memory", "12M", "--json", "a.json"},
                 4, "--max-memory");
}

TEST_F(CommandLine, FullDiskIsReported) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  EXPECT_EQ(run_isoloop(scratch_.path(), {"info", "ring_5x5x3_uint8.raw"}, "/dev/full").exit_code,
            3);
}

TEST_F(CommandLine, FindsTheLoopsOfARealEngine) {
  const std::filesystem::path file =
      std::filesystem::path(ISOLOOP_TEST_DATA) / "volumes/engine_half_128x128x64_uint8.raw";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "needs " << file;
  const ProcessResult result = run({"loops", file.string(), "--iso", "70", "--json", "-"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json.at("betti"), Json({{"b0", 1}, {"b1", 20}, {"b2", 0}}));
  EXPECT_EQ(json.at("surface").at("vertices"), 76906);
  EXPECT_EQ(json.at("loops").size(), 40U);
  EXPECT_EQ(json.at("verified"), true);
}

TEST_F(CommandLine, MoreVoxelsThanMemoryIsOverTheLimit) {
  expect_failure({"generate", "torus", "--size", "100000", "-o", "x.raw"}, 4, "");
}

TEST_F(CommandLine, IsoOutsideTheRangeIsAnEmptyAnswer) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  const ProcessResult result =
      run({"loops", "ring_5x5x3_uint8.raw", "--iso", "7", "--json", "a.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("outside the value range [0, 1]; 0 loops"), std::string::npos)
      << result.out;
  const Json json = Json::parse(scratch_.read("a.json"));
  EXPECT_EQ(json.at("loops"), Json::array());
  EXPECT_EQ(json.at("betti").at("b0"), 0);
}

TEST_F(CommandLine, AxesOfOneVoxelMakeASurface) {
  scratch_.write("dot_1x1x1_uint8.raw", "\1");
  scratch_.write("line_4x1x1_uint8.raw", std::string("\1\1\0\1", 4));
  Json json = Json::parse(run({"count", "dot_1x1x1_uint8.raw", "--iso", "1", "--json", "-"}).out);
  EXPECT_EQ(json.at("betti").at("b0"), 1);
  EXPECT_EQ(json.at("surface").at("genus"), 0);
  json = Json::parse(run({"loops", "line_4x1x1_uint8.raw", "--iso", "1", "--json", "-"}).out);
  EXPECT_EQ(json.at("betti").at("b0"), 2);
  EXPECT_TRUE(json.at("loops").empty());
}

TEST_F(CommandLine, FindsTheLoopsOfARing) {
  scratch_.write("ring.raw", ring_bytes());
  const ProcessResult result =
      run({"loops", "--dims", "5", "5", "3", "--type", "u8", "ring.raw", "--iso", "0.5", "--json",
           "a.json", "--csv", "a.csv", "--ply", "a.ply"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("1 handle + 1 tunnel = 2 × genus"), std::string::npos) << result.out;
  EXPECT_EQ(scratch_.files(), (Words{"a.csv", "a.json", "a.ply", "ring.raw"}));
  const Json json = Json::parse(scratch_.read("a.json"));
  EXPECT_EQ(json.at("betti"), Json({{"b0", 1}, {"b1", 1}, {"b2", 0}}));
  EXPECT_EQ(json.at("loops").size(), 2U);
  EXPECT_TRUE(scratch_.read("a.ply").starts_with("ply\nformat binary_little_endian 1.0\n"));
}

TEST_F(CommandLine, JsonOnStandardOutputStandsAlone) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  const ProcessResult result = run({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--json", "-"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(Json::accept(result.out)) << result.out;
}

TEST_F(CommandLine, FindsTheLoopsOfARingByPair) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  const ProcessResult result =
      run({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--engine", "pair", "--refine", "1",
           "--dump-pairs", "pairs.csv", "--stats", "--json", "a.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("volume triangles"), std::string::npos) << result.out;
  const Json json = Json::parse(scratch_.read("a.json"));
  EXPECT_EQ(json.at("conventions").at("engine"), "pair");
  EXPECT_EQ(json.at("conventions").at("refinement"), "1");
  EXPECT_EQ(json.at("loops").size(), 2U);
  const std::string pairs = scratch_.read("pairs.csv");
  EXPECT_EQ(std::count(pairs.begin(), pairs.end(), '\n'), 3) << pairs;
}

TEST_F(CommandLine, CurvesAreNoLongerThanWalksAlongEdges) {
  ASSERT_EQ(run({"generate", "trefoil", "--size", "40", "-o", "t.vdb"}).exit_code, 0);
  const Json edges = Json::parse(run({"loops", "t.vdb", "--json", "-"}).out);
  const ProcessResult result = run({"loops", "t.vdb", "--tighten", "curve", "--json", "-"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json curves = Json::parse(result.out);
  EXPECT_EQ(curves.at("conventions").at("tighten"), "curve");
  ASSERT_EQ(curves.at("loops").size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(curves.at("loops").at(i).at("length").get<double>(),
              edges.at("loops").at(i).at("length").get<double>());
  }
}

TEST_F(CommandLine, PairGoesWithExactSizes) {
  ASSERT_EQ(run({"generate", "torus", "--size", "40", "-o", "t.vdb"}).exit_code, 0);
  const ProcessResult result =
      run({"loops", "t.vdb", "--engine", "pair", "--geodesic", "exact", "--json", "-"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json.at("conventions").at("engine"), "pair");
  EXPECT_EQ(json.at("conventions").at("geodesic"), "exact");
  const Json dual = Json::parse(run({"loops", "t.vdb", "--geodesic", "exact", "--json", "-"}).out);
  ASSERT_EQ(json.at("loops").size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(json.at("loops").at(i).at("size"), dual.at("loops").at(i).at("size"));
  }
}

TEST_F(CommandLine, OpenBoundaryTellsNoSidesApart) {
  // A ring whose row y = 0 the border cuts off: a bent rod with two open ends.
  std::string bytes(60, '\0');
  for (const std::size_t place : {1, 3, 6, 8, 11, 12, 13}) bytes[20 + place] = '\1';
  scratch_.write("arc_5x4x3_uint8.raw", bytes);
  for (const char* engine : {"dual", "pair"}) {
    const ProcessResult result =
        run({"loops", "arc_5x4x3_uint8.raw", "--iso", "0.5", "--open-boundary", "--engine", engine,
             "--json", "a.json", "--csv", "a.csv", "--ply", "a.ply"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("2 border curves"), std::string::npos) << result.out;
    const Json json = Json::parse(scratch_.read("a.json"));
    EXPECT_EQ(json.at("betti"), Json({{"b0", 1}, {"b1", 1}, {"b2", 0}}));
    ASSERT_EQ(json.at("loops").size(), 1U);
    const Json& loop = json.at("loops").at(0);
    EXPECT_EQ(loop.at("kind"), "loop");
    EXPECT_EQ(loop.at("fix"), "none");
    EXPECT_EQ(loop.at("certificate"),
              Json({{"inside", "unknown"}, {"outside", "unknown"}, {"surface", "nontrivial"}}));
    EXPECT_NE(scratch_.read("a.csv").find("\n1,loop,none,"), std::string::npos);
  }
  const ProcessResult count =
      run({"count", "arc_5x4x3_uint8.raw", "--iso", "0.5", "--open-boundary", "--json", "-"});
  ASSERT_EQ(count.exit_code, 0) << count.err;
  EXPECT_EQ(Json::parse(count.out).at("betti").at("b1"), 1);
  const Json closed =
      Json::parse(run({"count", "arc_5x4x3_uint8.raw", "--iso", "0.5", "--json", "-"}).out);
  EXPECT_EQ(closed.at("betti").at("b1"), 0);
}

TEST_F(CommandLine, WhatNeedsSidesIsAUsageErrorWithAnOpenBoundary) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  const Words open{"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--open-boundary"};
  const auto with = [&](const Words& more) {
    Words arguments = open;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  expect_failure(with({"--side", "handle"}), 2, "--side handle");
  expect_failure(with({"--tighten", "basis"}), 2, "--tighten basis");
  scratch_.write("line_4x1x1_uint8.raw", std::string("\1\1\0\1", 4));
  expect_failure({"count", "line_4x1x1_uint8.raw", "--iso", "1", "--open-boundary"}, 2,
                 "two voxels");
}

TEST_F(CommandLine, StatisticsLeaveStandardOutputToTheReportThatAsksForIt) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  const ProcessResult result =
      run({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--stats", "--json", "-"});
  EXPECT_TRUE(Json::accept(result.out)) << result.out;
  EXPECT_NE(result.err.find("volume triangles"), std::string::npos) << result.err;
}

TEST_F(CommandLine, FlagsOfTheOtherEngineAreAUsageError) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  expect_failure({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--refine", "1"}, 2, "--refine");
  expect_failure({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--dump-pairs", "p.csv"}, 2,
                 "--dump-pairs");
  expect_failure({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--engine", "tree"}, 2,
                 "--engine");
}

TEST_F(CommandLine, FiltersDoNotRenumber) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  const Json json = Json::parse(
      run({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--side", "tunnel", "--json", "-"}).out);
  ASSERT_EQ(json.at("loops").size(), 1U);
  EXPECT_EQ(json.at("loops").at(0).at("kind"), "tunnel");
  EXPECT_EQ(json.at("loops").at(0).at("id"), 1);
  EXPECT_EQ(json.at("filter").at("found"), 2);
}

TEST_F(CommandLine, GeneratedRawFileComesWithTheFlagsToReadIt) {
  const ProcessResult written = run({"generate", "torus", "--size", "40", "-o", "t.raw"});
  ASSERT_EQ(written.exit_code, 0) << written.err;
  EXPECT_EQ(written.out, "");
  EXPECT_NE(written.err.find("b0 1, b1 1, b2 0"), std::string::npos) << written.err;
  const std::string start = "isoloop loops ";
  Words arguments{"count"};
  std::istringstream words(written.err.substr(written.err.find(start) + start.size()));
  for (std::string word; words >> word;) arguments.push_back(word);
  arguments.insert(arguments.end(), {"--json", "-"});
  const ProcessResult read = run(arguments);
  ASSERT_EQ(read.exit_code, 0) << read.err;
  EXPECT_EQ(Json::parse(read.out).at("betti"), Json({{"b0", 1}, {"b1", 1}, {"b2", 0}}));
}

TEST_F(CommandLine, GeneratedLevelSetNeedsNoFlags) {
  ASSERT_EQ(run({"generate", "torus", "--size", "40", "-o", "t.vdb"}).exit_code, 0);
  const ProcessResult read = run({"count", "t.vdb", "--json", "-"});
  ASSERT_EQ(read.exit_code, 0) << read.err;
  EXPECT_EQ(Json::parse(read.out).at("betti"), Json({{"b0", 1}, {"b1", 1}, {"b2", 0}}));
}

TEST_F(CommandLine, UnknownShapeIsAUsageErrorThatNamesTheShapes) {
  expect_failure({"generate", "teapot", "-o", "x.raw"}, 2, "torus");
}

TEST_F(CommandLine, SameBytesForEveryThreadCount) {
  ASSERT_EQ(run({"generate", "lattice", "--size", "48", "-o", "b.vdb"}).exit_code, 0);
  Words outputs;
  for (const char* threads : {"1", "2", "7"}) {
    const ProcessResult result = run({"loops", "b.vdb", "--threads", threads, "--json", "-"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    Json json = Json::parse(result.out);
    json.erase("seconds");
    json.erase("peak_bytes");
    outputs.push_back(json.dump());
    const ProcessResult pairs =
        run({"loops", "b.vdb", "--threads", threads, "--engine", "pair", "--dump-pairs", "-"});
    ASSERT_EQ(pairs.exit_code, 0) << pairs.err;
    outputs.back() += pairs.out;
  }
  EXPECT_EQ(outputs[0], outputs[1]);
  EXPECT_EQ(outputs[0], outputs[2]);
}

}  // namespace
}  // namespace isoloop
