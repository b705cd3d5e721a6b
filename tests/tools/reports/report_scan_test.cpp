#include "tools/reports/report_scan.h"

#include <limits>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/errors.h"
#include "tests/samples/sample_run.h"
#include "tools/runs/scan_run.h"

namespace isoloop {
namespace {

ScanRun scanned_run() {
  ScanRun run{empty_run()};
  const auto row = [](double iso, std::int64_t b1, std::int64_t voxels) {
    return ScanRow{iso, {1, b1, 0}, 2 - 2 * b1, b1, voxels};
  };
  run.scan.rows = {row(0.5, 7, 900), row(1, 2, 800), row(2, 2, 700), row(3, 2, 600),
                   row(4, 0, 500)};
  run.scan.plateaus = find_plateaus(run.scan.rows, 1000);
  run.scan.proposed = proposed_row(run.scan.rows, run.scan.plateaus);
  return run;
}

template <class Write>
std::string text_of(const ScanRun& run, const Write& write) {
  std::ostringstream out;
  write(out, run);
  return out.str();
}

TEST(ReportScan, TableHasARowForEachPlateauAndAProposal) {
  const std::string table = text_of(scanned_run(), write_scan_table);
  EXPECT_NE(table.find("1 to 3      2   1   2   0   -2  widest, no. 1\n"), std::string::npos)
      << table;
  EXPECT_NE(table.find("proposed: --iso 2, in the middle of the widest plateau, 1 to 3\n"),
            std::string::npos)
      << table;
}

TEST(ReportScan, TableSaysWhyNothingIsProposed) {
  ScanRun run = scanned_run();
  run.scan.rows.resize(1);
  run.scan.plateaus = find_plateaus(run.scan.rows, 1000);
  run.scan.proposed = proposed_row(run.scan.rows, run.scan.plateaus);
  EXPECT_NE(text_of(run, write_scan_table).find("no iso value is proposed"), std::string::npos);
}

TEST(ReportScan, CsvHasALineForEachIsoValue) {
  EXPECT_EQ(text_of(scanned_run(), write_scan_csv),
            "iso,b0,b1,b2,euler,genus,inside_voxels,plateau,meaningful\n"
            "0.5,1,7,0,-12,7,900,1,0\n1,1,2,0,-2,2,800,2,1\n2,1,2,0,-2,2,700,2,1\n"
            "3,1,2,0,-2,2,600,2,1\n4,1,0,0,2,0,500,3,0\n");
}

TEST(ReportScan, JsonHoldsRowsPlateausAndTheProposal) {
  const auto json = nlohmann::json::parse(text_of(scanned_run(), write_scan_json));
  EXPECT_EQ(json["schema"], "isoloop/1");
  EXPECT_EQ(json["scan"].size(), 5U);
  EXPECT_EQ(json["scan"][0]["b1"], 7);
  EXPECT_EQ(json["plateaus"][1]["to"], 3.0);
  EXPECT_EQ(json["proposed_iso"], 2.0);
}

Volume volume_of(const VoxelArray& values) {
  Volume volume;
  volume.values = values;
  return volume;
}

TEST(ScanValues, AreAllIntegersOfASmallRange) {
  const Volume bytes = volume_of(std::vector<std::uint8_t>());
  const auto values = scan_values({}, view(bytes), {3, 255});
  EXPECT_EQ(values.size(), 253U);
  EXPECT_EQ(values.front(), 3.0);
  EXPECT_EQ(values.back(), 255.0);
  EXPECT_EQ(scan_values({.values = 3, .from = 0, .to = 5}, view(bytes), {3, 255}),
            (std::vector<double>{0, 3, 5}));
}

TEST(ScanValues, AreEvenlySpacedElsewhere) {
  const Volume floats = volume_of(std::vector<float>());
  EXPECT_EQ(scan_values({}, view(floats), {-1, 1}).size(), 256U);
  EXPECT_EQ(scan_values({.values = 3, .from = {}, .to = {}}, view(floats), {-1, 1}),
            (std::vector<double>{-1, 0, 1}));
  EXPECT_EQ(scan_values({}, view(floats), {2, 2}), std::vector<double>{2});
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Volume some =
      volume_of(std::vector<float>{-3.0F, std::numeric_limits<float>::infinity(), 5.0F});
  const auto between = scan_values({}, view(some), {-3, infinite, {}});
  EXPECT_EQ(between.front(), -3.0);
  EXPECT_EQ(between.back(), 5.0) << "infinite voxels leave the finite ones their steps";
  const Volume shorts = volume_of(std::vector<std::int16_t>());
  EXPECT_EQ(scan_values({}, view(shorts), {-1000, 30000}).size(), 256U);
}

TEST(ScanValues, OfNothingAreRefused) {
  const Volume bytes = volume_of(std::vector<std::uint8_t>());
  EXPECT_THROW(scan_values({.values = {}, .from = 5, .to = 4}, view(bytes), {0, 9}),
               InvalidArgument);
  EXPECT_THROW(scan_values({.values = {}, .from = 4.2, .to = 4.4}, view(bytes), {0, 9}),
               InvalidArgument);
  EXPECT_THROW(scan_values({.values = 0, .from = {}, .to = {}}, view(bytes), {0, 9}),
               InvalidArgument);
}

}  // namespace
}  // namespace isoloop
