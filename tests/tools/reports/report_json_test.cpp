#include "tools/reports/report_json.h"

#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/samples/sample_run.h"

namespace isoloop {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const LoopsRun& run) {
  std::ostringstream out;
  write_json(out, run);
  return out.str();
}

Json parsed(const LoopsRun& run) { return Json::parse(text_of(run)); }

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST(ReportJson, StartsWithItsSchema) {
  const Json json = parsed(torus_run());
  EXPECT_EQ(keys_of(json).front(), "schema");
  EXPECT_EQ(json.at("schema"), "isoloop/1");
}

TEST(ReportJson, HasTheNamesOfTheDesign) {
  const Json json = parsed(torus_run());
  for (const char* key : {"input", "iso", "conventions", "surface", "components", "betti", "loops",
                          "verified", "seconds", "peak_bytes"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(keys_of(json.at("surface")),
            (std::vector<std::string>{"vertices", "triangles", "components", "euler", "genus"}));
  EXPECT_EQ(keys_of(json.at("betti")), (std::vector<std::string>{"b0", "b1", "b2"}));
  EXPECT_EQ(
      keys_of(json.at("loops").at(0)),
      (std::vector<std::string>{"id", "kind", "fix", "length", "found_length", "size", "component",
                                "center_index", "center_world", "curves", "certificate"}));
  EXPECT_EQ(keys_of(json.at("seconds")),
            (std::vector<std::string>{"read", "surface", "closest", "sizes", "pass", "loops",
                                      "total", "slowest_loops"}));
}

TEST(ReportJson, StatesTheUnitWhereTheFileDoes) {
  LoopsRun run = torus_run();
  EXPECT_EQ(parsed(run).at("conventions").at("unit"), "length and size: unit of the spacing");
  run.volume.unit = "µm";
  EXPECT_EQ(parsed(run).at("conventions").at("unit"), "length and size: µm");
}

TEST(ReportJson, TellsOfFeaturesWhereAskedTo) {
  const Json json = parsed(torus_run_with_features());
  EXPECT_EQ(json["loops"][0]["feature"],
            Json::parse(R"({"label": 1, "area": 4.0, "axis": [0.0, 1.0, 0.0], "depth": 1.5,
                            "thickness": 0.6366197723675814, "least_girth": 2.0,
                            "mean_girth": 2.25})"));
  EXPECT_EQ(json["loops"][1]["feature"]["label"], 2);
  EXPECT_FALSE(parsed(torus_run())["loops"][0].contains("feature"));
}

TEST(ReportJson, TellsNoSidesApartWithAnOpenBoundary) {
  const Json json = parsed(open_run());
  EXPECT_EQ(json.at("components").at(0).at("bounds"), "unknown");
  EXPECT_EQ(json.at("components").at(0).at("borders"), 2);
  EXPECT_TRUE(json.at("conventions").contains("betti"));
  EXPECT_EQ(keys_of(json.at("total")), std::vector<std::string>{"loops"});
  ASSERT_EQ(json.at("loops").size(), 1U);
  const Json loop = json.at("loops").at(0);
  EXPECT_EQ(loop.at("kind"), "loop");
  EXPECT_EQ(loop.at("fix"), "none");
  EXPECT_EQ(loop.at("certificate"),
            Json({{"inside", "unknown"}, {"outside", "unknown"}, {"surface", "nontrivial"}}));
}

TEST(ReportJson, ListsEveryComponentOfTheSurface) {
  LoopsRun run = torus_run();
  run.analysis.surface.components.push_back(
      {.vertices = 6, .triangles = 8, .euler = 2, .genus = 0, .bounds_cavity = true});
  const Json components = parsed(run).at("components");
  ASSERT_EQ(components.size(), 2U);
  EXPECT_EQ(components.at(0).at("genus"), 1);
  EXPECT_EQ(components.at(0).at("bounds"), "solid");
  EXPECT_EQ(
      components.at(1),
      Json({{"vertices", 6}, {"triangles", 8}, {"euler", 2}, {"genus", 0}, {"bounds", "cavity"}}));
}

TEST(ReportJson, StatesTotalLengthsOfEachKind) {
  LoopsRun run = torus_run();
  run.analysis.least_handle_length = 2.5;
  const Json json = parsed(run);
  EXPECT_EQ(json.at("conventions").at("tighten"), "basis");
  EXPECT_DOUBLE_EQ(json.at("total").at("handles").at("length"), 2.598);
  EXPECT_DOUBLE_EQ(json.at("total").at("handles").at("found_length"), 2.75);
  EXPECT_DOUBLE_EQ(json.at("total").at("handles").at("lower_bound"), 2.5);
  EXPECT_DOUBLE_EQ(json.at("total").at("tunnels").at("length"), 10.392);
  EXPECT_TRUE(json.at("total").at("tunnels").at("lower_bound").is_null());
}

TEST(ReportJson, StatesCountsAndCost) {
  const Json json = parsed(torus_run());
  EXPECT_EQ(json.at("surface").at("vertices"), 9);
  EXPECT_EQ(json.at("surface").at("genus"), 1);
  EXPECT_EQ(json.at("betti").at("b1"), 1);
  EXPECT_EQ(json.at("iso"), 0.25);
  EXPECT_EQ(json.at("verified"), true);
  EXPECT_EQ(json.at("seconds").at("total"), 1.5);
  EXPECT_EQ(json.at("peak_bytes"), 1024);
}

TEST(ReportJson, SaysWhichLoopBoundsWhere) {
  const Json loops = parsed(torus_run()).at("loops");
  EXPECT_EQ(loops.at(0).at("kind"), "handle");
  EXPECT_EQ(loops.at(0).at("fix"), "cut");
  EXPECT_EQ(loops.at(0).at("certificate"),
            Json({{"inside", "trivial"}, {"outside", "nontrivial"}}));
  EXPECT_EQ(loops.at(1).at("kind"), "tunnel");
  EXPECT_EQ(loops.at(1).at("fix"), "fill");
  EXPECT_EQ(loops.at(1).at("certificate"),
            Json({{"inside", "nontrivial"}, {"outside", "trivial"}}));
}

TEST(ReportJson, WritesInfiniteSizeAsNull) {
  const Json json = parsed(torus_run());
  EXPECT_TRUE(json.at("loops").at(1).at("size").is_null());
  EXPECT_NE(json.at("conventions").at("infinite_size").get<std::string>().find("null"),
            std::string::npos);
}

TEST(ReportJson, PutsCurvesInTheWorldFrame) {
  const Json curve = parsed(torus_run()).at("loops").at(0).at("curves").at(0);
  ASSERT_EQ(curve.size(), 3U);
  EXPECT_DOUBLE_EQ(curve.at(0).at(0).get<double>(), 104.5);
  EXPECT_DOUBLE_EQ(curve.at(0).at(1).get<double>(), 2.5);
  EXPECT_DOUBLE_EQ(curve.at(0).at(2).get<double>(), 2.5);
}

TEST(ReportJson, DrawsGeodesicsWhereThereAreAny) {
  LoopsRun run = torus_run();
  run.reported[0].geodesics = {{{{0, 1}, 0.5}, {{1, 2}, 0.5}, {{2, 2}, 0.0}, {{2, 0}, 0.25}}};
  const Json loops = parsed(run).at("loops");
  const Json curve = loops.at(0).at("curves").at(0);
  ASSERT_EQ(curve.size(), 4U);
  const auto& points = run.analysis.surface.points;
  EXPECT_NEAR(curve.at(0).at(2).get<double>(), 0.5 * (points[0][2] + points[1][2]) / 2.0, 1e-6);
  EXPECT_EQ(loops.at(1).at("curves").at(0).size(), 3U);
}

TEST(ReportJson, PrintsFrameAndAffine) {
  const Json coordinates = parsed(torus_run()).at("conventions").at("coordinates");
  EXPECT_EQ(coordinates.at("frame"), "world");
  EXPECT_EQ(coordinates.at("affine"),
            Json::parse("[[0.5,0,0,100],[0,0.5,0,0],[0,0,0.5,0],[0,0,0,1]]"));
}

TEST(ReportJson, NamesTheTopology) {
  LoopsRun run = torus_run();
  EXPECT_EQ(parsed(run).at("conventions").at("topology"), "trilinear");
  run.level.topology = Topology::simple;
  EXPECT_EQ(parsed(run).at("conventions").at("topology"), "simple");
}

TEST(ReportJson, NamesTheInsideRule) {
  LoopsRun run = torus_run();
  EXPECT_EQ(parsed(run).at("conventions").at("inside"), "f <= 0.25");
  run.level.inside = InsideRule::above;
  EXPECT_EQ(parsed(run).at("conventions").at("inside"), "f >= 0.25");
}

TEST(ReportJson, NamesTheEngineAndItsRefinement) {
  LoopsRun run = torus_run();
  EXPECT_EQ(parsed(run).at("conventions").at("engine"), "dual");
  EXPECT_FALSE(parsed(run).at("conventions").contains("refinement"));
  EXPECT_FALSE(parsed(run).at("seconds").contains("pair"));
  run.engine = Engine::pair;
  run.refinement = Refinement::first;
  run.analysis.seconds.pair = 0.5;
  EXPECT_EQ(parsed(run).at("conventions").at("engine"), "pair");
  EXPECT_EQ(parsed(run).at("conventions").at("refinement"), "1");
  EXPECT_EQ(parsed(run).at("seconds").at("pair"), 0.5);
}

TEST(ReportJson, NamesTheComplexAndTheGradingOfAnOctree) {
  LoopsRun run = torus_run();
  run.analysis.complex = ComplexKind::automatic;  // a surface without loops
  EXPECT_TRUE(parsed(run).at("conventions").at("complex").is_null());
  run.analysis.complex = ComplexKind::grid;
  EXPECT_EQ(parsed(run).at("conventions").at("complex"), "grid");
  EXPECT_FALSE(parsed(run).at("conventions").contains("grading"));
  run.analysis.complex = ComplexKind::octree;
  run.grading = 2;
  EXPECT_EQ(parsed(run).at("conventions").at("complex"), "octree");
  EXPECT_EQ(parsed(run).at("conventions").at("grading"), 2);
}

TEST(ReportJson, LeavesLoopsOutOfACount) {
  std::ostringstream out;
  write_count_json(out, torus_run());
  const Json json = Json::parse(out.str());
  EXPECT_FALSE(json.contains("loops"));
  EXPECT_FALSE(json.at("conventions").contains("engine"));
  EXPECT_EQ(json.at("betti").at("b0"), 1);
}

TEST(ReportJson, WritesAnEmptySurface) {
  const Json json = parsed(empty_run());
  EXPECT_EQ(json.at("loops"), Json::array());
  EXPECT_EQ(json.at("surface").at("triangles"), 0);
}

TEST(ReportJson, TakesAFileNameThatIsNotUtf8) {
  LoopsRun run = torus_run();
  run.file = "bad\xFFname.raw";
  EXPECT_NO_THROW(parsed(run));
}

TEST(ReportJson, WritesInfiniteVoxelsAsNull) {
  LoopsRun run = torus_run();
  run.range.max = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(parsed(run).at("input").at("maximum").is_null());
}

TEST(ReportJson, DiffersOnlyInCostBetweenRuns) {
  LoopsRun other = torus_run();
  other.cost = {.read_seconds = 9.0, .total_seconds = 10.0, .peak_bytes = 7};
  other.analysis.seconds.sizes = 3.0;
  std::istringstream a(text_of(torus_run()));
  std::istringstream b(text_of(other));
  std::string line_a;
  std::string line_b;
  while (std::getline(a, line_a) && std::getline(b, line_b)) {
    const bool cost = line_a.starts_with("  \"seconds\"") || line_a.starts_with("  \"peak_bytes\"");
    if (!cost) {
      EXPECT_EQ(line_a, line_b);
    }
  }
}

}  // namespace
}  // namespace isoloop
