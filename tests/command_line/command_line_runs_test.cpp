// Promises of whole runs, kept by the built executable.
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/command_line/fixture.h"
#include "tests/samples/real_data.h"

namespace isoloop {
namespace {

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

TEST_F(CommandLine, FindsTheLoopsOfARealEngine) {
  const std::string name = "volumes/engine_half_128x128x64_uint8.raw";
  ISOLOOP_NEEDS(name);
  const ProcessResult result = run({"loops", testing::data(name), "--iso", "70", "--json", "-"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json.at("betti"), Json({{"b0", 1}, {"b1", 20}, {"b2", 0}}));
  EXPECT_EQ(json.at("surface").at("vertices"), 76906);
  EXPECT_EQ(json.at("loops").size(), 40U);
  EXPECT_EQ(json.at("verified"), true);
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

TEST_F(CommandLine, StatisticsLeaveStandardOutputToTheReportThatAsksForIt) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  const ProcessResult result =
      run({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--stats", "--json", "-"});
  EXPECT_TRUE(Json::accept(result.out)) << result.out;
  EXPECT_NE(result.err.find("volume triangles"), std::string::npos) << result.err;
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

TEST_F(CommandLine, GeneratedLevelSetHoldsANarrowBandAndHasTheSameLoops) {
  const std::string raw = "t_160x160x58_float32.raw";
  for (const std::string& file : {std::string("t.vdb"), raw})
    ASSERT_EQ(run({"generate", "torus", "--size", "160", "-o", file}).exit_code, 0);
  EXPECT_LT(3 * std::filesystem::file_size(scratch_.path() / "t.vdb"),
            std::filesystem::file_size(scratch_.path() / raw));
  const ProcessResult band = run({"loops", "t.vdb", "--json", "-"});
  const ProcessResult whole = run({"loops", raw, "--inside", "below", "--iso", "0", "--json", "-"});
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  for (const char* kind : {"handles", "tunnels"}) {
    const auto length = [&](const ProcessResult& result) {
      return Json::parse(result.out).at("total").at(kind).at("length").get<double>();
    };
    EXPECT_GT(length(band), 0.0);
    EXPECT_NEAR(length(band) / length(whole), 1.0, 0.01) << kind;
  }
}

TEST_F(CommandLine, SameBytesForEveryThreadCount) {
  ASSERT_EQ(run({"generate", "lattice", "--size", "48", "-o", "b.vdb"}).exit_code, 0);
  Words outputs;
  for (const char* threads : {"1", "2", "16"}) {
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

TEST_F(CommandLine, FarMoreThreadsThanCoresFitIntoLittleMemory) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer takes more than the limit for itself";
#endif
  ASSERT_EQ(run({"generate", "torus", "--size", "64", "-o", "b.vdb"}).exit_code, 0);
  const ProcessResult result =
      run({"loops", "b.vdb", "--threads", "128", "--max-memory", "96M", "--json", "-"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST_F(CommandLine, WithLittleAddressSpaceEndsByTheDocumentedExitCode) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer reserves more address space than any machine has";
#endif
  ASSERT_EQ(run({"generate", "torus", "--size", "64", "-o", "b.nrrd"}).exit_code, 0);
  int found = 0;
  int short_of_memory = 0;
  for (int kilobytes = 64'000; kilobytes <= 320'000; kilobytes += 16'000) {
    const ProcessResult result =
        run_program("/bin/sh", scratch_.path(),
                    {"-c",
                     "ulimit -v " + std::to_string(kilobytes) + "; exec \"$0\" loops b.nrrd " +
                         "--iso 0 --inside below --features",
                     isoloop_program().string()});
    if (result.exit_code == 0) ++found;
    if (result.exit_code == 4) ++short_of_memory;
    const bool loaded = result.err.find("loading shared libraries") == std::string::npos;
    EXPECT_TRUE(!loaded || result.exit_code == 0 || result.exit_code == 4)
        << kilobytes << ": " << result.exit_code << ' ' << result.err;
    EXPECT_EQ(result.err.find("terminate called"), std::string::npos) << result.err;
  }
  EXPECT_GT(found, 0);
  EXPECT_GT(short_of_memory, 0);
}

TEST_F(CommandLine, AFailedAllocationNamesItsStage) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer ends the process where memory runs out";
#endif
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  expect_failure({"loops", "ring_5x5x3_uint8.raw", "--iso", "0.5", "--max-memory", "1000"}, 4,
                 "the stage '");
}

TEST_F(CommandLine, AMeshIsNotToldToBeCropped) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer ends the process where memory runs out";
#endif
  ASSERT_EQ(run({"generate", "torus", "--size", "64", "-o", "t.vdb"}).exit_code, 0);
  ASSERT_EQ(run({"loops", "t.vdb", "--surface", "t.stl"}).exit_code, 0);
  const ProcessResult failed = run({"count", "t.stl", "--resolution", "64", "--max-memory", "40M"});
  ASSERT_EQ(failed.exit_code, 4) << failed.err;
  EXPECT_EQ(failed.err.find("--crop"), std::string::npos) << failed.err;
  EXPECT_NE(failed.err.find("larger voxels"), std::string::npos) << failed.err;
}

TEST_F(CommandLine, FlagsThatMeanNothingHereAreRefused) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  expect_failure({"generate", "torus", "--holes", "3", "-o", "t.vdb"}, 2, "it is for plate");
  expect_failure({"generate", "plate", "--cells", "3", "-o", "t.vdb"}, 2, "it is for lattice");
  expect_failure({"loops", "ring_5x5x3_uint8.raw", "--iso", "0.5", "--triangles", "9"}, 2,
                 "without --html");
  expect_failure({"repair", "ring_5x5x3_uint8.raw", "--iso", "0.5", "--genus", "0", "--dry-run",
                  "-o", "r.raw"},
                 2, "--dry-run");
}

TEST_F(CommandLine, GenerateRefusesANameThatContradictsTheShape) {
  expect_failure({"generate", "torus", "--size", "64", "-o", "t_10x10x10_uint8.raw"}, 2,
                 "states 10 x 10 x 10 voxels of uint8, but the shape has 64 x 64 x 26 of float32");
}

TEST_F(CommandLine, ScanCountsAsCountDoes) {
  ASSERT_EQ(run({"generate", "plate", "--size", "24", "--holes", "2", "-o", "p.vdb"}).exit_code, 0);
  const ProcessResult scanned = run({"scan", "p.vdb", "--from", "-1", "--to", "1", "--values", "9",
                                     "--json", "-", "--svg", "curves.svg"});
  ASSERT_EQ(scanned.exit_code, 0) << scanned.err;
  const Json json = Json::parse(scanned.out);
  ASSERT_EQ(json.at("scan").size(), 9U);
  for (const Json& row : json.at("scan")) {
    const ProcessResult counted =
        run({"count", "p.vdb", "--iso", row.at("iso").dump(), "--json", "-"});
    EXPECT_EQ(Json::parse(counted.out).at("betti"),
              Json({{"b0", row.at("b0")}, {"b1", row.at("b1")}, {"b2", row.at("b2")}}))
        << row;
  }
  EXPECT_TRUE(scratch_.read("curves.svg").starts_with("<svg"));
  expect_failure({"scan", "p.vdb", "--from", "2", "--to", "1"}, 2, "leave no iso value");
  expect_failure({"scan", "p.vdb", "--from"}, 2, "--from wants a number");
}

TEST_F(CommandLine, PageAndExportsStandBesideTheTable) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  const Words flags{"ring_5x5x3_uint8.raw", "--iso", "0.5"};
  const auto with = [&](Words arguments, const Words& more) {
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  const ProcessResult viewed = run(with({"view"}, {"-o", "page.html"}));
  EXPECT_EQ(viewed.exit_code, 0) << viewed.err;
  EXPECT_NE(viewed.out.find("verified: "), std::string::npos);
  const ProcessResult found = run(with({"loops"}, {"--html", "b.html", "--curves", "c.obj",
                                                   "--curves", "c.vtp", "--surface", "s.stl"}));
  EXPECT_EQ(found.exit_code, 0) << found.err;
  EXPECT_EQ(scratch_.read("page.html"), scratch_.read("b.html"));
  for (const char* file : {"c.obj", "c.vtp", "s.stl"}) EXPECT_FALSE(scratch_.read(file).empty());
  expect_failure(with({"loops"}, {"--curves", "c.txt"}), 2, ".vtp, .obj and .mrk.json");
  expect_failure(with({"loops"}, {"--surface", "s.mrk.json"}), 2, ".ply, .obj, .stl and .vtp");
}

TEST_F(CommandLine, ProgressAsJsonIsAnObjectALineAndSoIsAnError) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  const ProcessResult result = run({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--log-json"});
  EXPECT_EQ(result.exit_code, 0);
  std::istringstream lines(result.err);
  std::string stages;
  for (std::string line; std::getline(lines, line);)
    stages += Json::parse(line).at("stage").get<std::string>() + ' ';
  EXPECT_EQ(stages, "surface closest sizes pass loops checks ");
  const ProcessResult missing = run({"count", "none.raw", "--iso", "1", "--log-json"});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_EQ(Json::parse(missing.err).at("event"), "error");
  EXPECT_EQ(Json::parse(missing.err).at("code"), 3);
  EXPECT_EQ(run({"count", "ring_5x5x3_uint8.raw", "--iso", "1", "--quiet"}).err, "");
  expect_failure({"count", "ring_5x5x3_uint8.raw", "--iso", "1", "--quiet", "--dims"}, 2, "--dims");
}

}  // namespace
}  // namespace isoloop
