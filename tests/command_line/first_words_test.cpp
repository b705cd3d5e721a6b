// What people type first: help without a refusal, and a way on where there is one.
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/command_line/fixture.h"
#include "tests/samples/dicom_samples.h"
#include "tests/samples/mesh_samples.h"

namespace isoloop {
namespace {

class FirstWords : public CommandLine {
 protected:
  FirstWords() { scratch_.write(ring_, ring_bytes()); }

  void expect_words(const ProcessResult& result, const Words& all) const {
    EXPECT_EQ(result.exit_code, 0) << result.err;
    for (const std::string& words : all)
      EXPECT_NE((result.out + result.err).find(words), std::string::npos)
          << words << " is not in\n"
          << result.out << result.err;
  }

  /// The built executable in a shell, in the folder of the test.
  int run_in_shell(const std::string& command) const {
    return std::system(("cd '" + scratch_.path().string() + "' && " + command).c_str());
  }

  const std::string ring_ = "ring_5x5x3_uint8.raw";
  const std::string program_ = std::string("'") + ISOLOOP_EXECUTABLE + "'";
};

TEST_F(FirstWords, NoneAreAQuestionForHelp) {
  const ProcessResult help = run({"-h"});
  const ProcessResult none = run({});
  EXPECT_EQ(none.exit_code, 0);
  EXPECT_EQ(none.out, help.out);
  EXPECT_EQ(none.err, "");
}

TEST_F(FirstWords, HelpAndVersionAreUnderstoodInEverySpelling) {
  const std::string help = run({"-h"}).out;
  EXPECT_EQ(run({"help"}).out, help);
  EXPECT_EQ(run({"--help"}).out, help);
  const std::string count = run({"count", "-h"}).out;
  EXPECT_EQ(run({"help", "count"}).out, count);
  EXPECT_EQ(run({"count", "--help"}).out, count);
  EXPECT_EQ(run({"count", "x.raw", "--iso", "--help"}).out, count);
  EXPECT_EQ(run({"count", "--no-such-flag", "-h"}).out, count);
  const std::string version = run({"--version"}).out;
  for (const char* word : {"version", "-v", "-V"}) EXPECT_EQ(run({word}).out, version) << word;
}

TEST_F(FirstWords, AFileIsDescribedAndCountedAndTheNextCommandsAreNamed) {
  const ProcessResult result = run({ring_});
  expect_words(result, {"dims       5 x 5 x 3", "tunnels     1", "chosen by --iso auto",
                        "isoloop loops " + ring_ + " --iso 0.5"});
  scratch_.write("a b.raw", ring_bytes());
  expect_words(run({"a b.raw", "--dims", "5", "5", "3", "--type", "u8", "--iso", "1"}),
               {"f >= 1", "isoloop view 'a b.raw' --dims 5 5 3 --type u8 --iso 1"});
  ASSERT_EQ(run({"generate", "torus", "--size", "16", "-o", "t.vdb"}).exit_code, 0);
  expect_words(run({"t.vdb"}), {"f <= 0", "isoloop loops t.vdb    "});
  expect_failure({"none.raw"}, 2, "none.raw is no file and no command");
}

TEST_F(FirstWords, ALabelMapIsDescribedWithItsLabels) {
  std::string labels(125, '\0');
  labels[62] = '\3';
  labels[63] = '\7';
  scratch_.write("labels_5x5x5_uint8.raw", labels);
  expect_words(run({"labels_5x5x5_uint8.raw"}), {"0, 3, 7 alone", "--label 3"});
  expect_words(run({"scan", "labels_5x5x5_uint8.raw", "--json", "-"}),
               {"\"proposed_iso\": null", "\"otsu_iso\": null"});
}

TEST_F(FirstWords, WhatIsNearlyACommandOrAFlagNamesTheOneThatIsMeant) {
  expect_failure({"lops", ring_}, 2, "did you mean loops?");
  expect_failure({"cuont", ring_}, 2, "did you mean count?");
  for (const char* flag : {"-iso", "--threshold", "-t", "--isso", "--isovalue"})
    expect_failure({"count", ring_, flag, "1"}, 2,
                   std::string(flag) + " is no flag of isoloop count; did you mean --iso?");
  expect_failure({"loops", ring_, "--min-sise=3"}, 2, "did you mean --min-size?");
  expect_failure({"count", ring_, "--qwertyuiop"}, 2, "--qwertyuiop is no flag of isoloop count (");
}

TEST_F(FirstWords, TheFirstFlagThatIsNoneIsNamedFirst) {
  expect_failure({"count", ring_, "--bbbbbb", "--aaaaaa"}, 2, "--bbbbbb");
  expect_failure({"count", ring_, "--aaaaaa", "--bbbbbb"}, 2, "--aaaaaa");
}

TEST_F(FirstWords, FlagsThatMeanNothingAreNamedInTheOrderTyped) {
  expect_failure({"count", ring_, "--iso", "1", "--series", "a", "--frame", "0"}, 2,
                 "--series means nothing");
  expect_failure({"count", ring_, "--iso", "1", "--frame", "0", "--series", "a"}, 2,
                 "--frame means nothing");
  expect_failure({"count", ring_, "--label", "1", "--iso", "1"}, 2,
                 "--label does not go with --iso");
  expect_failure({"count", ring_, "--iso", "1", "--label", "1"}, 2,
                 "--iso does not go with --label");
}

TEST_F(FirstWords, ASummaryIsOneLineForScripts) {
  const std::string counts = "iso=1 b0=1 b1=1 b2=0 euler=0 genus=1";
  EXPECT_EQ(run({"count", ring_, "--iso", "1", "--summary"}).out, counts + "\n");
  const std::string loops = run({"loops", ring_, "--iso", "1", "--summary"}).out;
  EXPECT_EQ(loops.find(counts + " handles=1 handle_length="), 0U) << loops;
  EXPECT_NE(loops.find(" tunnels=1 tunnel_length="), std::string::npos) << loops;
  EXPECT_EQ(loops.find('\n'), loops.size() - 1);
  EXPECT_EQ(run({"loops", ring_, "--iso", "1", "--side", "tunnel", "--summary"}).out.find("handle"),
            std::string::npos);
  EXPECT_EQ(run({"view", ring_, "--iso", "1", "--summary"}).out, loops);
  EXPECT_EQ(run({"scan", ring_, "--summary"}).out,
            "proposed_iso=1 proposed_by=otsu large_b0=1 large_b1=1 large_b2=0 ignored_below=0\n");
  const ProcessResult repaired =
      run({"repair", ring_, "--iso", "1", "--fill-tunnels", "99", "--dry-run", "--summary"});
  EXPECT_EQ(repaired.out.find("iso=1 b0=1 b1=0 b2=0 euler=2 genus=0 removals=1 kept=0 "), 0U)
      << repaired.out;
  const ProcessResult stats =
      run({"loops", ring_, "--iso", "1", "--engine", "pair", "--stats", "--summary"});
  EXPECT_EQ(stats.out.find('\n'), stats.out.size() - 1);
  EXPECT_NE(stats.err, "") << "statistics go to the other stream";
  expect_failure({"count", ring_, "--iso", "1", "--summary", "--json", "-"}, 2,
                 "--summary goes to");
  expect_failure({"loops", ring_, "--iso", "1", "--top", "3", "--csv", "-"}, 2, "--top is for");
  expect_failure({"loops", ring_, "--iso", "1", "--top", "3", "--summary"}, 2,
                 "--top does not go with --summary");
}

TEST_F(FirstWords, OnATerminalTheLargestThirtyLoopsAreShown) {
  if (run_in_shell("command -v script > /dev/null") != 0) GTEST_SKIP() << "needs script(1)";
  // Forty rings, each with a handle and a tunnel.
  std::string voxels(static_cast<std::size_t>(40 * 4) * 5 * 3, '\0');
  for (std::size_t ring = 0; ring < 40; ++ring)
    for (std::size_t y = 1; y < 4; ++y)
      for (std::size_t x = 0; x < 3; ++x)
        if (x != 1 || y != 2) voxels[4 * ring + x + 160 * (y + 5)] = 1;
  scratch_.write("rings_160x5x3_uint8.raw", voxels);
  const std::string command = program_ + " loops rings_160x5x3_uint8.raw --iso 1";
  ASSERT_EQ(run_in_shell("script -qec \"" + command + "\" typed > terminal.txt"), 0);
  ASSERT_EQ(run_in_shell(command + " --top 30 > top.txt"), 0);
  ASSERT_EQ(run_in_shell(command + " > all.txt"), 0);
  const auto rows_of = [&](const char* file) {
    const std::string text = scratch_.read(file);
    std::size_t rows = 0;
    for (std::size_t at = text.find(" bounds "); at != std::string::npos;
         at = text.find(" bounds ", at + 1))
      ++rows;
    return rows;
  };
  EXPECT_EQ(rows_of("all.txt"), 80U);
  EXPECT_EQ(rows_of("top.txt"), 30U);
  EXPECT_EQ(rows_of("terminal.txt"), 30U);
  EXPECT_NE(scratch_.read("terminal.txt").find("and 50 more: --top 0 shows all"),
            std::string::npos);
}

TEST_F(FirstWords, NoHelpListsAFlagThatItsCommandRefuses) {
  const auto lists = [&](const char* command, const char* flag) {
    return run({command, "--help-all"}).out.find(flag) != std::string::npos;
  };
  EXPECT_TRUE(lists("count", "--label") && lists("count", "--crop") &&
              lists("count", "--open-boundary"));
  EXPECT_FALSE(lists("scan", "--label"));
  EXPECT_FALSE(lists("repair", "--crop") || lists("repair", "--open-boundary"));
}

TEST_F(FirstWords, ThreeSpacingsMayHaveAUnit) {
  for (const Words& spacing : {Words{"0.5", "0.25", "2mm"}, Words{"0.5mm", "0.25mm", "2mm"},
                               Words{"0.5mm", "0.25", "2"}, Words{"0.5 0.25 2mm"}}) {
    Words words{"count", "--iso", "1", "--json", "-", "--spacing"};
    words.insert(words.end(), spacing.begin(), spacing.end());
    words.push_back(ring_);
    const ProcessResult result = run(words);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json counted = Json::parse(result.out);
    EXPECT_EQ(counted["input"]["spacing"], (std::vector<double>{0.5, 0.25, 2.0}));
  }
}

TEST_F(FirstWords, LengthsMayHaveAUnit) {
  // The ring in micrometres: its tunnel loop has a size of a few voxels.
  const Words base{"loops", ring_, "--iso", "1", "--spacing", "500um", "--json", "-"};
  const auto reported = [&](const Words& more) {
    Words words = base;
    words.insert(words.end(), more.begin(), more.end());
    const ProcessResult result = run(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(result.out);
  };
  const Json all = reported({});
  EXPECT_EQ(all.at("conventions").at("unit"), "length and size: µm");
  EXPECT_EQ(all.at("loops").size(), 2U);
  const Json few = reported({"--min-size", "0.001mm", "--max-size", "20mm"});
  EXPECT_DOUBLE_EQ(few.at("filter").at("min_size").get<double>(), 1.0);
  EXPECT_DOUBLE_EQ(few.at("filter").at("max_size").get<double>(), 20000.0);
  EXPECT_TRUE(reported({"--min-size", "20mm"}).at("loops").empty());
  expect_failure({"loops", ring_, "--iso", "1", "--min-size", "20mm"}, 2, "states no unit");
  expect_failure({"loops", ring_, "--iso", "1", "--min-size", "20parsec"}, 2, "no unit of length");
  const ProcessResult repaired = run({"repair", ring_, "--iso", "1", "--spacing", "1mm",
                                      "--fill-tunnels", "2cm", "--dry-run", "--json", "-"});
  ASSERT_EQ(repaired.exit_code, 0) << repaired.err;
  EXPECT_EQ(Json::parse(repaired.out).at("removals").size(), 1U);
}

TEST_F(FirstWords, StandardInputAndPipesAreReadWhereATypeIsStated) {
  EXPECT_EQ(
      run_in_shell(program_ + " count - --dims 5 5 3 --type u8 --iso 1 --json a.json < " + ring_),
      0);
  EXPECT_EQ(Json::parse(scratch_.read("a.json")).at("betti").at("b1"), 1);
  EXPECT_EQ(Json::parse(scratch_.read("a.json")).at("input").at("file"), "-");
  ASSERT_EQ(mkfifo((scratch_.path() / "pipe_5x5x3_uint8.raw").c_str(), 0600), 0);
  EXPECT_EQ(
      run_in_shell("cat " + ring_ + " > pipe_5x5x3_uint8.raw & cd '" + scratch_.path().string() +
                   "' && " + program_ +
                   " count pipe_5x5x3_uint8.raw --dims 5 5 3 --type u8 --iso 1 --json b.json"),
      0);
  EXPECT_EQ(Json::parse(scratch_.read("b.json")).at("betti").at("b1"), 1);
  EXPECT_NE(run_in_shell(program_ + " count - --iso 1 2> err < " + ring_), 0);
  EXPECT_NE(scratch_.read("err").find("--dims and --type"), std::string::npos);
}

TEST_F(FirstWords, TheNullDeviceIsAnOutput) {
  const ProcessResult result = run({"loops", ring_, "--iso", "1", "--json", "/dev/null", "--csv",
                                    "/dev/null", "--ply", "/dev/null"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(FirstWords, CountAndScanTakeThreadsCsvAndConnectivity) {
  scratch_.write("pair_2x2x2_uint8.raw", std::string("\1\0\0\0\0\0\0\1", 8));
  for (const auto& [connectivity, components] : {std::pair{"6", 2}, {"18", 2}, {"26", 1}}) {
    const Words flags{"--connectivity", connectivity, "--threads", "1", "--csv", "t.csv"};
    Words count{"count", "pair_2x2x2_uint8.raw", "--iso", "1", "--json", "-"};
    count.insert(count.end(), flags.begin(), flags.end());
    ProcessResult result = run(count);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(Json::parse(result.out).at("betti").at("b0"), components);
    EXPECT_TRUE(scratch_.read("t.csv").starts_with("component,vertices,triangles,euler,genus,"));
    Words scan{"scan", "pair_2x2x2_uint8.raw", "--json", "-"};
    scan.insert(scan.end(), flags.begin(), flags.end());
    result = run(scan);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(Json::parse(result.out).at("scan").at(1).at("b0"), components);
  }
}

TEST_F(FirstWords, AMeshHasADefaultResolution) {
  scratch_.write("box.off",
                 test::mesh_bytes(test::box_mesh({0, 0, 0}, {1, 1, 1}), test::MeshFormat::off));
  const ProcessResult result = run({"count", "box.off", "--json", "-"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Json::parse(result.out).at("betti").at("b0"), 1);
}

TEST_F(FirstWords, ViewWritesAPageBesideItsFile) {
  const ProcessResult result = run({"view", ring_, "--iso", "1"});
  expect_words(result, {"page: " + ring_ + ".html"});
  EXPECT_TRUE(scratch_.read(ring_ + ".html").starts_with("<!"));
}

TEST_F(FirstWords, AFolderOfSeriesListsThemWithTheCommandForEach) {
  std::filesystem::create_directory(scratch_.path() / "scans");
  for (const char* series : {"1.2.3", "1.2.34"}) {
    for (int z = 0; z < 3; ++z) {
      test::DicomSlice slice = test::dicom_slice_at(z);
      slice.series = series;
      scratch_.write("scans/" + std::string(series) + "_" + std::to_string(z), slice.file());
    }
  }
  for (const Words& words : {Words{"scans"}, Words{"info", "scans"}})
    expect_words(run(words),
                 {"2 series of DICOM slices", "scans --series 1.2.3\n", "scans --series 1.2.34\n"});
  expect_words(run({"info", "scans", "--series", "1.2.34"}), {"int16"});
}

TEST_F(FirstWords, WarningsAreThereWhereAPersonWouldFrown) {
  std::string labels(125, '\0');
  labels[62] = '\3';
  labels[63] = '\7';
  scratch_.write("labels_5x5x5_uint8.raw", labels);
  expect_words(run({"count", "labels_5x5x5_uint8.raw", "--iso", "1"}),
               {"warning: an iso value parts numbers, and these look like labels"});
  expect_words(run({"loops", ring_, "--iso", "1"}), {"note: the file states no spacing"});
  EXPECT_EQ(run({"loops", ring_, "--iso", "1", "--spacing", "2"}).out.find("states no spacing"),
            std::string::npos);
  expect_words(
      run({"count", ring_, "--iso", "0.5", "--inside", "below"}),
      {"warning: 100 % of the voxels at the border of the volume are inside", "--inside above"});
  // A block of 23 x 23 x 3 voxels with a hole at every second one, 11 x 11 each in nine layers.
  std::string sieve;
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 67; ++y)
      for (int x = 0; x < 67; ++x) sieve.push_back(x % 2 == 1 && y % 2 == 1 ? '\0' : '\x64');
  scratch_.write("sieve_67x67x2_uint8.raw", sieve);
  expect_words(run({"count", "sieve_67x67x2_uint8.raw", "--iso", "50"}),
               {"warning: the solid has 1089 tunnels"});
}

TEST_F(FirstWords, HelpBeginsWithWhatEverybodyNeedsAndTheRestIsInHelpAll) {
  const std::string help = run({"loops", "-h"}).out;
  const std::string all = run({"loops", "--help-all"}).out;
  EXPECT_LT(help.find("--iso "), help.find("--dims "));
  for (const char* flag : {"--engine", "--refine", "--skip", "--max-voxels"}) {
    EXPECT_EQ(help.find(flag), std::string::npos) << flag;
    EXPECT_NE(all.find(flag), std::string::npos) << flag;
  }
  EXPECT_NE(help.find("isoloop loops --help-all"), std::string::npos);
}

}  // namespace
}  // namespace isoloop
