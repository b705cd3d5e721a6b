#include "tools/reports/report_stats.h"

#include <sstream>

#include <gtest/gtest.h>

#include "tests/samples/sample_run.h"

namespace isoloop {
namespace {

TEST(ReportStats, PartsTheTimeIntoSizesAndAllElse) {
  LoopsRun run = torus_run();
  run.engine = Engine::pair;
  run.analysis.volume_triangles = 123;
  run.analysis.seconds = {
      .surface = 1.0, .closest = 2.0, .sizes = 4.0, .pass = 8.0, .pair = 16.0, .loops = 32.0};
  std::ostringstream out;
  write_stats(out, run);
  EXPECT_EQ(out.str(),
            "surface triangles  volume triangles  genus  geodesic s  loops s  engine\n"
            "               18               123      1        6.00    57.00    pair\n");
}

}  // namespace
}  // namespace isoloop
