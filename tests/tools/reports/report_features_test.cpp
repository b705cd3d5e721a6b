#include "tools/reports/report_features.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/errors.h"
#include "core/base/memory_budget.h"
#include "tests/samples/sample_run.h"

namespace isoloop {
namespace {

std::string table_of(const LoopsRun& run) {
  std::ostringstream out;
  write_features(out, run);
  return out.str();
}

const std::vector<std::uint16_t>& shorts(const Volume& volume) {
  return std::get<std::vector<std::uint16_t>>(volume.values);
}

TEST(ReportFeatures, HasOneRowForEachReportedLoop) {
  LoopsRun run = torus_run_with_features();
  EXPECT_EQ(
      table_of(run),
      "\nfeatures\n"
      "id  kind    label   area  depth  thickness  least girth  mean girth                axis\n"
      " 1  handle      1  4.000  1.500      0.637        2.000       2.250  (0.00, 1.00, 0.00)\n"
      " 1  tunnel      2  9.000  0.500      3.183       10.000      10.250  (0.00, 0.00, 1.00)\n");
  run.reported.erase(run.reported.begin());
  EXPECT_EQ(table_of(run).find("handle"), std::string::npos);
  EXPECT_NE(table_of(run).find(" tunnel      2  9.000"), std::string::npos) << table_of(run);
  run.reported.clear();
  EXPECT_EQ(table_of(run), "");
}

TEST(ReportFeatures, TurnTheAxisToTheWorld) {
  LoopsRun run = torus_run_with_features();
  run.volume.direction = {Vec3{0, 1, 0}, Vec3{0, 0, -1}, Vec3{-1, 0, 0}};
  EXPECT_EQ(feature_json(run, run.reported[0])["axis"], (std::vector<double>{0, 0, -1}));
  EXPECT_EQ(feature_json(run, run.reported[1])["axis"], (std::vector<double>{-1, 0, 0}));
}

TEST(ReportFeatures, TheShortestLoopsLabelWinsWhereFeaturesOverlap) {
  LoopsRun run = torus_run_with_features();  // handle: vertices 0 to 5; tunnel: 0, 3, 6, 7
  EXPECT_EQ(vertex_labels(run), (std::vector<std::uint32_t>{1, 1, 1, 1, 1, 1, 2, 2, 0}));
  std::swap(run.reported[0].length, run.reported[1].length);
  EXPECT_EQ(vertex_labels(run), (std::vector<std::uint32_t>{2, 1, 1, 2, 1, 1, 2, 2, 0}));
  run.reported.pop_back();
  EXPECT_EQ(vertex_labels(run), (std::vector<std::uint32_t>{1, 1, 1, 1, 1, 1, 0, 0, 0}));
}

TEST(ReportFeatures, LabelTheVoxelsBesideTheirVertices) {
  LoopsRun run = torus_run_with_features();
  // Each vertex on a grid edge along x; the first one's leads out of the volume.
  for (std::size_t i = 0; i < 9; ++i)
    run.analysis.surface.points[i] = {i == 0 ? -0.5F : 2.25F, static_cast<float>(i), 4.0F};
  run.cost.max_bytes = unlimited_bytes;
  const Volume labels = label_volume(run);
  EXPECT_EQ(labels.dims, run.volume.dims);
  EXPECT_EQ(labels.spacing, run.volume.spacing);
  EXPECT_EQ(labels.origin, run.volume.origin);
  EXPECT_EQ(labels.frame, run.volume.frame);
  const auto at = [&](std::size_t x, std::size_t y) { return shorts(labels)[x + 10 * (y + 40)]; };
  EXPECT_EQ(at(0, 0), 1);
  for (std::size_t y = 1; y < 9; ++y) {
    const int label = y < 6 ? 1 : y < 8 ? 2 : 0;
    EXPECT_EQ(at(1, y), 0);
    EXPECT_EQ(at(2, y), label);
    EXPECT_EQ(at(3, y), label);
    EXPECT_EQ(at(4, y), 0);
  }
  EXPECT_EQ(std::count(shorts(labels).begin(), shorts(labels).end(), 0), 1000 - 15);
}

TEST(ReportFeatures, AskForRoomForLabels) {
  LoopsRun run = torus_run_with_features();  // 10 x 10 x 10 voxels, 9 vertices, 10 of features
  run.cost.max_bytes = 110 * 9 + 4 * 10 + 2 * 1000;
  EXPECT_EQ(shorts(label_volume(run)).size(), 1000);
  EXPECT_THROW(label_volume(run, 8), LimitExceeded);
  --run.cost.max_bytes;
  EXPECT_THROW(label_volume(run), LimitExceeded);
}

}  // namespace
}  // namespace isoloop
