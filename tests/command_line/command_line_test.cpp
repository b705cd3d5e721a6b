// Promises of the command line, kept by the built executable: help, refusals and exit codes.
#include <filesystem>
#include <iterator>
#include <limits>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/command_line/fixture.h"
#include "tests/samples/mesh_samples.h"

namespace isoloop {
namespace {

TEST_F(CommandLine, HelpShowsThreeExamplesAndSucceeds) {
  const std::regex example("\n  isoloop [a-z]+ ");
  for (const Words& arguments :
       {Words{"-h"}, Words{"info", "-h"}, Words{"count", "-h"}, Words{"loops", "-h"},
        Words{"scan", "-h"}, Words{"view", "-h"}, Words{"demo", "-h"}, Words{"convert", "-h"},
        Words{"generate", "--help"}}) {
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
  static const std::regex built(
      "built with .* [0-9.]+, OpenVDB [0-9.]+, oneTBB [0-9.]+, Boost [0-9.]+, zlib [0-9.]+, "
      "libtiff "
      "[0-9.]+, libpng [0-9.]+, CLI11 [0-9.]+, nlohmann-json [0-9.]+\n");
  EXPECT_TRUE(std::regex_search(result.out, built)) << result.out;
}

TEST_F(CommandLine, DemoFindsWhatIsKnownAndSaysWhereThePageIs) {
  const ProcessResult result = run({"demo", "-o", "new/demo"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("tunnels     20 "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("/new/demo/engine_block.html\n"), std::string::npos) << result.out;
  EXPECT_TRUE(std::filesystem::exists(scratch_.path() / "new/demo/engine_block.html"));
  EXPECT_TRUE(std::filesystem::exists(scratch_.path() / "new/demo/engine_block.vdb"));
  scratch_.write("file", {1});
  expect_failure({"demo", "-o", "file"}, 3, "file");
}

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
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer ends the process where memory runs out";
#endif
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
                  "--max-memory", "48M", "--json", "a.json"},
                 4, "the stage '");
}

TEST_F(CommandLine, FullDiskIsReported) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  EXPECT_EQ(run_isoloop(scratch_.path(), {"info", "ring_5x5x3_uint8.raw"}, "/dev/full").exit_code,
            4);
}

TEST_F(CommandLine, TooManyVoxelsAreRefusedNamingTheFlag) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  expect_failure({"info", "ring_5x5x3_uint8.raw", "--max-voxels", "74"}, 4, "--max-voxels");
  EXPECT_EQ(run({"info", "ring_5x5x3_uint8.raw", "--max-voxels", "75"}).exit_code, 0);
}

TEST_F(CommandLine, FindsTheLoopsOfAMesh) {
  scratch_.write("ring.off", test::mesh_bytes(test::torus_mesh({50, 60, 70}, 3, 1, 30, 20),
                                              test::MeshFormat::off));
  const ProcessResult result = run({"loops", "ring.off", "--resolution", "40", "--json", "-"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["surface"]["genus"], 1);
  ASSERT_EQ(json["loops"].size(), 2U);
  EXPECT_NEAR(json["loops"][1]["center_world"][2].get<double>(), 70.0, 1.0);
  expect_failure({"loops", "ring.off", "--voxel", "1e-6"}, 4, "--max-memory");
}

TEST_F(CommandLine, MoreVoxelsThanMemoryIsOverTheLimit) {
  expect_failure({"generate", "torus", "--size", "100000", "-o", "x.raw"}, 4, "");
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

TEST_F(CommandLine, FlagsOfTheOtherEngineAreAUsageError) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  expect_failure({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--refine", "1"}, 2, "--refine");
  expect_failure({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--dump-pairs", "p.csv"}, 2,
                 "--dump-pairs");
  expect_failure({"loops", "ring_5x5x3_uint8.raw", "--iso", "1", "--engine", "tree"}, 2,
                 "--engine");
}

TEST_F(CommandLine, UnknownShapeIsAUsageErrorThatNamesTheShapes) {
  expect_failure({"generate", "teapot", "-o", "x.raw"}, 2, "torus");
}

}  // namespace
}  // namespace isoloop
