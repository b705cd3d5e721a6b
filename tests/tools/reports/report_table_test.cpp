#include "tools/reports/report_table.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/samples/sample_run.h"

namespace isoloop {
namespace {

std::string table_of(const LoopsRun& run, std::size_t most_rows = 0) {
  std::ostringstream out;
  write_table(out, run, most_rows);
  return out.str();
}

std::string count_table_of(const CountRun& run) {
  std::ostringstream out;
  write_count_table(out, run);
  return out.str();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(ReportTable, NamesComponentsTunnelsAndCavities) {
  const std::string table = table_of(torus_run());
  EXPECT_NE(table.find("components  1  (b0"), std::string::npos) << table;
  EXPECT_NE(table.find("tunnels     1  (b1"), std::string::npos) << table;
  EXPECT_NE(table.find("cavities    0  (b2"), std::string::npos) << table;
  EXPECT_NE(table.find("9 vertices, 18 triangles, 1 component"), std::string::npos) << table;
  EXPECT_NE(table.find("genus 1"), std::string::npos) << table;
}

TEST(ReportTable, CountsBorderCurvesWithAnOpenBoundary) {
  LoopsRun run = open_run();
  const std::string table = table_of(run);
  EXPECT_NE(table.find("2 border curves"), std::string::npos) << table;
  EXPECT_NE(table.find("nontrivial on M"), std::string::npos) << table;
  EXPECT_NE(table.find("total length of 1 loop: 2.598"), std::string::npos) << table;
  EXPECT_EQ(table.find("tunnel"), std::string::npos) << table;
  run.analysis.surface.components.push_back(
      {.vertices = 6, .triangles = 8, .euler = 2, .genus = 0, .borders = 0});
  const std::vector<std::string> lines = lines_of(count_table_of(run));
  ASSERT_GE(lines.size(), 3U);
  EXPECT_TRUE(lines[lines.size() - 3].ends_with("border curves")) << lines[lines.size() - 3];
  EXPECT_TRUE(lines[lines.size() - 2].ends_with("  2")) << lines[lines.size() - 2];
  EXPECT_TRUE(lines.back().ends_with("  0")) << lines.back();
}

TEST(ReportTable, ListsTheLargestComponentsWhereOnlyCounted) {
  LoopsRun run = torus_run();
  EXPECT_EQ(count_table_of(run).find("bounds"), std::string::npos);
  for (int i = 0; i < 30; ++i)
    run.analysis.surface.components.push_back({.vertices = 100 + i,
                                               .triangles = 196 + 2 * i,
                                               .euler = 2,
                                               .genus = 0,
                                               .bounds_cavity = i % 2 == 1});
  const std::vector<std::string> lines = lines_of(count_table_of(run));
  const auto head = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find("component  vertices  triangles") != std::string::npos;
  });
  ASSERT_EQ(lines.end() - head, 22);
  EXPECT_EQ(head[1], "       30       129        254  2      0  cavity");
  EXPECT_EQ(head[2], "       29       128        252  2      0  solid");
  EXPECT_EQ(head[21], "and 11 smaller ones: --json lists all");
}

TEST(ReportTable, AlignsItsColumns) {
  const std::vector<std::string> lines = lines_of(table_of(torus_run()));
  const auto head = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find("certificate") != std::string::npos;
  });
  ASSERT_NE(head, lines.end());
  ASSERT_GE(lines.end() - head, 3);
  const std::size_t column = head->find("certificate");
  EXPECT_EQ((head + 1)->find("bounds inside"), column);
  EXPECT_EQ((head + 2)->find("bounds outside"), column);
}

TEST(ReportTable, SaysWhatFixesALoop) {
  const std::string table = table_of(torus_run());
  EXPECT_NE(table.find("handle  cut"), std::string::npos) << table;
  EXPECT_NE(table.find("tunnel  fill"), std::string::npos) << table;
}

TEST(ReportTable, PrintsInfiniteSizeAsInf) {
  EXPECT_NE(table_of(torus_run()).find("  inf  "), std::string::npos);
}

TEST(ReportTable, GivesCentresInIndicesAndInTheWorld) {
  const std::string table = table_of(torus_run());
  EXPECT_NE(table.find("(8.0, 5.0, 5.0)  (104.000, 2.500, 2.500)"), std::string::npos) << table;
}

TEST(ReportTable, AddsUpEachKind) {
  const std::string table = table_of(torus_run());
  EXPECT_NE(table.find("total length of 1 handle loop: 2.598 (as found: 2.750)\n"),
            std::string::npos)
      << table;
  LoopsRun run = torus_run();
  run.tighten = Tighten::none;
  EXPECT_NE(table_of(run).find("total length of 1 tunnel loop: 10.392\n"), std::string::npos);
}

TEST(ReportTable, EndsWithWhatWasVerified) {
  EXPECT_EQ(lines_of(table_of(torus_run())).back(),
            "verified: every loop is closed, lies on M and is certified; 1 handle + 1 tunnel = 2 × "
            "genus");
}

TEST(ReportTable, ShowsTheLargestLoopsFirstWhereRowsAreFew) {
  const LoopsRun run = torus_run();
  const std::string all = table_of(run);
  EXPECT_LT(all.find("handle  cut"), all.find("tunnel  fill")) << "in the order of the report";
  EXPECT_EQ(all.find("more:"), std::string::npos);
  const std::string two = table_of(run, 2);
  EXPECT_GT(two.find("handle  cut"), two.find("tunnel  fill")) << "the tunnel's is infinite";
  const std::string one = table_of(run, 1);
  EXPECT_EQ(one.find("handle  cut"), std::string::npos) << one;
  EXPECT_NE(one.find("and 1 more: --top 0 shows all, --json lists all\n"), std::string::npos)
      << one;
  EXPECT_NE(one.find("total length of 1 handle loop"), std::string::npos) << "of all";
}

TEST(ReportTable, NamesMinSizeWhereMostLoopsAreAsSmallAsThoseOfNoise) {
  LoopsRun run = torus_run();  // spacing 0.5
  run.reported.assign(99, run.reported[0]);
  for (Loop& loop : run.reported) loop.size = 1.0;
  EXPECT_EQ(table_of(run).find("below 3 voxels"), std::string::npos) << "they are few";
  run.reported.resize(160, torus_run().reported[1]);
  EXPECT_NE(table_of(run).find("note: 99 of 160 loops have a size below 3 voxels, as noise has; "
                               "--min-size 1.5 leaves them out\n"),
            std::string::npos);
  run.reported.resize(200, torus_run().reported[1]);
  EXPECT_EQ(table_of(run).find("below 3 voxels"), std::string::npos) << "not half of them";
}

TEST(ReportTable, NamesTheUnitThatTheFileStates) {
  LoopsRun run = torus_run();
  EXPECT_EQ(table_of(run).find("length ("), std::string::npos);
  run.volume.unit = "mm";
  const std::string table = table_of(run);
  EXPECT_NE(table.find("length (mm)  size (mm)"), std::string::npos) << table;
  EXPECT_NE(table.find("total length of 1 handle loop: 2.598 mm (as found: 2.750)"),
            std::string::npos)
      << table;
}

TEST(ReportTable, SaysHowManyLoopsAFilterLeft) {
  LoopsRun run = torus_run();
  run.filter.tunnels = false;
  run.reported.pop_back();
  const std::string table = table_of(run);
  EXPECT_NE(table.find("reported: 1 of 2 loops"), std::string::npos) << table;
  EXPECT_EQ(table.find("tunnel loop:"), std::string::npos) << table;
}

TEST(ReportTable, SaysWhyThereIsNoSurface) {
  const std::string table = table_of(empty_run());
  EXPECT_NE(table.find("no surface: iso 7 is outside the value range [-1, 2]; 0 loops"),
            std::string::npos)
      << table;
}

TEST(ReportTable, SaysWhenEveryVoxelIsInside) {
  LoopsRun run = torus_run();
  run.level.iso = 9.0;
  EXPECT_NE(table_of(run).find("so every voxel is inside"), std::string::npos);
}

TEST(ReportTable, LeavesLoopsOutOfACount) {
  const std::string table = count_table_of(torus_run());
  EXPECT_EQ(table.find("certificate"), std::string::npos);
  EXPECT_EQ(table.find("verified"), std::string::npos);
}

}  // namespace
}  // namespace isoloop
