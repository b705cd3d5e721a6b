#include "tools/reports/report_pairs.h"

#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/samples/sample_run.h"

namespace isoloop {
namespace {

TEST(ReportPairs, HasOneRowForEachPairInTheFrameOfTheInput) {
  LoopsRun run = torus_run();
  run.analysis.surface.points[1] = {6.0F, 4.0F, 2.0F};
  run.analysis.surface.points[2] = {8.0F, 5.0F, 5.5F};
  run.analysis.pairs = {
      {.edge = {1, 2}, .side = Side::inside, .piece = 7, .size = 1.5F, .cycle = {}},
      {.edge = {2, 1},
       .side = Side::outside,
       .piece = 9,
       .size = std::numeric_limits<float>::infinity(),
       .cycle = {}}};
  std::ostringstream out;
  write_pairs(out, run);
  EXPECT_EQ(out.str(),
            "side,size,piece,a,a_world_x,a_world_y,a_world_z,b,b_world_x,b_world_y,b_world_z\n"
            "inside,1.5,7,1,103,2,1,2,104,2.5,2.75\n"
            "outside,inf,9,2,104,2.5,2.75,1,103,2,1\n");
}

}  // namespace
}  // namespace isoloop
