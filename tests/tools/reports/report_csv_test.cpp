#include "tools/reports/report_csv.h"

#include <sstream>

#include <gtest/gtest.h>

#include "tests/samples/sample_run.h"

namespace isoloop {
namespace {

std::string csv_of(const LoopsRun& run) {
  std::ostringstream out;
  write_csv(out, run);
  return out.str();
}

TEST(ReportCsv, HasOneRowForEachLoop) {
  EXPECT_EQ(csv_of(torus_run()),
            "id,kind,fix,length,size,component,curves,"
            "center_index_i,center_index_j,center_index_k,"
            "center_world_x,center_world_y,center_world_z,"
            "certificate_inside,certificate_outside\n"
            "1,handle,cut,2.598,1.5,0,1,8,5,5,104,2.5,2.5,trivial,nontrivial\n"
            "1,tunnel,fill,10.392,inf,0,1,5,5,5,102.5,2.5,2.5,nontrivial,trivial\n");
}

TEST(ReportCsv, KnowsNoSideOfALoopWithAnOpenBoundary) {
  EXPECT_NE(
      csv_of(open_run()).find("\n1,loop,none,2.598,1.5,0,1,8,5,5,104,2.5,2.5,unknown,unknown\n"),
      std::string::npos);
}

TEST(ReportCsv, TellsOfFeaturesWhereAskedTo) {
  const std::string csv = csv_of(torus_run_with_features());
  EXPECT_NE(csv.find("certificate_outside,label,area,depth,thickness,least_girth,mean_girth,"
                     "axis_x,axis_y,axis_z\n"),
            std::string::npos);
  EXPECT_NE(csv.find("nontrivial,trivial,2,9,0.5,3.18309886183790"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",10,10.25,0,0,1\n"), std::string::npos) << csv;
}

TEST(ReportCsv, HasOnlyItsHeadWithoutLoops) {
  const std::string csv = csv_of(empty_run());
  EXPECT_EQ(csv.find('\n'), csv.size() - 1);
}

}  // namespace
}  // namespace isoloop
