#include "tools/bench/report_bench.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tools/bench/bench_plot.h"

namespace isoloop {
namespace {

using Json = nlohmann::ordered_json;

BenchRow row_of(std::int64_t size, int threads, double seconds) {
  const std::vector<StageCost> stages{{"surface", 0.5, 0.5, 1 << 20},
                                      {"loops", seconds, seconds / threads, 3 << 20}};
  return {.volume = "lattice:7",
          .size = size,
          .threads = threads,
          .median = {.dims = {size, size, size},
                     .triangles = 3000,
                     .genus = 833,
                     .loops = 1666,
                     .slowest_loops_seconds = seconds / 4,
                     .whole = whole_of(stages),
                     .stages = stages}};
}

BenchRun two_sizes() {
  BenchRun run{.machine = {"Abacus", 2, std::uint64_t{3} << 30, "Linux", "g++ 12", "1.0"},
               .repeat = 3};
  run.rows = {row_of(64, 1, 1.0), row_of(64, 2, 1.0), row_of(128, 1, 12.0)};
  run.rows.push_back(
      {.volume = "a,b.raw", .threads = 1, .failure = "no such file", .exit_code = 3});
  run.growth = {{.volume = "lattice:7",
                 .threads = 1,
                 .least_size = 64,
                 .largest_size = 128,
                 .wall = 1.25,
                 .cpu = {{"all", 1.5}, {"surface", std::nullopt}, {"loops", 2.25}}}};
  run.efficiency = {{.volume = "lattice:7",
                     .size = 64,
                     .threads = 2,
                     .least_threads = 1,
                     .speedup = 1.5,
                     .efficiency = {{"all", 0.75}}}};
  return run;
}

template <class Write>
std::string text_of(const Write& write) {
  std::ostringstream out;
  write(out, two_sizes());
  return out.str();
}

TEST(ReportBench, TableNamesTheMachineAndHasARowForEachCase) {
  const std::string table = text_of(write_bench_table);
  EXPECT_NE(table.find("Abacus, 2 cores, 3.0 GiB; Linux; isoloop 1.0, g++ 12\nmedians of 3 runs"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("lattice:7    64        1   262144       3000    833   1.50    1.50         "
                       "3         12.0         25 %\n"),
            std::string::npos)
      << table;
}

TEST(ReportBench, TableSaysWhyACaseFailed) {
  EXPECT_NE(text_of(write_bench_table).find("  no such file\n"), std::string::npos);
}

TEST(ReportBench, TableHasGrowthAndEfficiencyOfEachStage) {
  const std::string table = text_of(write_bench_table);
  EXPECT_NE(table.find("lattice:7  64 to 128        1  1.50        -   2.25        1.25       -\n"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("lattice:7    64        2       1     1.50  0.75        -      -\n"),
            std::string::npos)
      << table;
}

TEST(ReportBench, CsvHasALineForEachStageAndForEachFailure) {
  std::istringstream lines(text_of(write_bench_csv));
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  ASSERT_EQ(all.size(), 1U + 3U * 3U + 1U);
  EXPECT_EQ(all[1],
            "lattice:7,64,64,64,64,262144,3000,833,1666,1,3,all,1.5,1.5,3145728,12,2000,0.25,");
  EXPECT_EQ(all[2],
            "lattice:7,64,64,64,64,262144,3000,833,1666,1,3,surface,0.5,0.5,1048576,4,6000,,");
  const auto columns = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  for (std::size_t i = 1; i + 1 < all.size(); ++i) EXPECT_EQ(columns(all[i]), columns(all[0]));
  EXPECT_EQ(columns(all.back()), columns(all[0]) + 1);  // one within quotes
  EXPECT_TRUE(all.back().starts_with("\"a,b.raw\",")) << all.back();
  EXPECT_TRUE(all.back().ends_with(",no such file")) << all.back();
}

TEST(ReportBench, JsonHasAllOfIt) {
  const Json json = Json::parse(text_of(write_bench_json));
  EXPECT_EQ(json.at("schema"), "isoloop-bench/1");
  EXPECT_EQ(json.at("machine").at("processor"), "Abacus");
  EXPECT_EQ(json.at("repeat"), 3);
  ASSERT_EQ(json.at("runs").size(), 4U);
  const Json& run = json.at("runs").at(0);
  EXPECT_EQ(run.at("failure"), nullptr);
  EXPECT_EQ(run.at("stages").at(0).at("stage"), "all");
  EXPECT_EQ(run.at("stages").at(2).at("cpu_seconds"), 1.0);
  EXPECT_EQ(run.at("slowest_loops_seconds"), 0.25);
  EXPECT_EQ(json.at("runs").at(3).at("failure"), "no such file");
  EXPECT_EQ(json.at("growth").at(0).at("cpu_seconds").at("loops"), 2.25);
  EXPECT_EQ(json.at("growth").at(0).at("cpu_seconds").at("surface"), nullptr);
  EXPECT_EQ(json.at("efficiency").at(0).at("speedup"), 1.5);
}

TEST(BenchPlot, DrawsALineForEachVolumeOnTheLeastThreads) {
  const std::string svg = text_of(write_bench_svg);
  EXPECT_TRUE(svg.starts_with("<svg ")) << svg;
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_NE(svg.find(">lattice:7</text>"), std::string::npos);
  EXPECT_EQ(svg.find("a,b.raw"), std::string::npos);
  std::size_t circles = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos;
       at = svg.find("<circle", at + 1))
    ++circles;
  EXPECT_EQ(circles, 2U);
}

TEST(BenchPlot, IsAPictureThoughNothingWasMeasured) {
  std::ostringstream out;
  write_bench_svg(out, {});
  EXPECT_EQ(out.str().find("nan"), std::string::npos);
  EXPECT_EQ(out.str().find("inf"), std::string::npos);
}

}  // namespace
}  // namespace isoloop
