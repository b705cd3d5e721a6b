#include "tools/reports/scan_plot.h"

#include <algorithm>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

std::string plot_of(std::vector<ScanRow> rows) {
  Scan scan;
  scan.rows = std::move(rows);
  scan.plateaus = {{.last = std::min<std::size_t>(1, scan.rows.size() - 1), .meaningful = true}};
  scan.proposed = 0;
  std::ostringstream out;
  write_scan_svg(out, scan, InsideRule::above);
  return out.str();
}

ScanRow row(double iso, std::int64_t b1) { return {iso, {1, b1, 0}, 2 - 2 * b1, b1, 500}; }

TEST(ScanPlot, DrawsThreeCurvesThatStepFromCountToCount) {
  const std::string svg = plot_of({row(0, 9), row(1, 9), row(2, 0)});
  // 0 and 2 are the ends of the axis, 9 the top and 0 the bottom.
  EXPECT_NE(svg.find("class=\"curve b1\" d=\"M64.0 40.0L784.0 40.0L784.0 316.0\""),
            std::string::npos)
      << svg;
  for (const char* name : {"curve b0\" d=\"M64.0", "curve b2\" d=\"M64.0"})
    EXPECT_NE(svg.find(name), std::string::npos);
}

TEST(ScanPlot, ShadesPlateausAndMarksTheProposal) {
  const std::string svg = plot_of({row(0, 9), row(1, 9), row(2, 0)});
  EXPECT_NE(svg.find("class=\"plateau\" x=\"64.0\" y=\"40.0\" width=\"360.0\""), std::string::npos);
  EXPECT_NE(svg.find("proposed 0<"), std::string::npos);
}

TEST(ScanPlot, OfOneValueHasNoNumberThatIsNone) {
  const std::string svg = plot_of({row(3, 0)});
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace isoloop
