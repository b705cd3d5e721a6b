#include "tools/reports/report_curves.h"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/errors.h"
#include "tests/samples/sample_run.h"

namespace isoloop {
namespace {

std::size_t count_of(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
    ++count;
  return count;
}

TEST(ReportCurves, VtpHasAClosedLineForEachCurve) {
  const std::string vtp = written(curves_report("a.vtp"), torus_run());
  EXPECT_NE(vtp.find("NumberOfPoints=\"6\" NumberOfLines=\"2\""), std::string::npos) << vtp;
  EXPECT_NE(vtp.find("0 1 2 0\n3 4 5 3\n"), std::string::npos) << vtp;
  EXPECT_NE(vtp.find("Name=\"size\" format=\"ascii\"> 1.5 -1<"), std::string::npos) << vtp;
  EXPECT_NE(vtp.find("104.5 2.5 2.5\n"), std::string::npos) << vtp;
  EXPECT_NE(vtp.find("<!-- isoloop: frame world"), std::string::npos) << vtp;
}

TEST(ReportCurves, ObjHasAnObjectForEachLoop) {
  const std::string obj = written(curves_report("a.obj"), torus_run());
  EXPECT_TRUE(obj.starts_with("# isoloop: frame world")) << obj;
  EXPECT_EQ(count_of(obj, "\no "), 2U);
  EXPECT_EQ(count_of(obj, "\nv "), 6U);
  EXPECT_NE(obj.find("\nl 1 2 3 1\n"), std::string::npos) << obj;
  EXPECT_NE(obj.find("\nl 4 5 6 4\n"), std::string::npos) << obj;
}

TEST(ReportCurves, MarkupsAreClosedCurvesInAFrameThatSlicerKnows) {
  LoopsRun run = torus_run();
  const auto lps = nlohmann::json::parse(written(curves_report("a.mrk.json"), run));
  ASSERT_EQ(lps["markups"].size(), 2U);
  const auto& markup = lps["markups"][0];
  EXPECT_EQ(markup["type"], "ClosedCurve");
  EXPECT_EQ(markup["coordinateSystem"], "LPS");
  EXPECT_EQ(markup["name"], "handle 1");
  EXPECT_EQ(markup["controlPoints"].size(), 3U);
  EXPECT_EQ(markup["controlPoints"][0]["position"][0], 104.5);
  run.volume.frame = Frame::ras;
  EXPECT_EQ(nlohmann::json::parse(
                written(curves_report("a.mrk.json"), run))["markups"][1]["coordinateSystem"],
            "RAS");
}

TEST(ReportCurves, OfNoLoopsAreEmptyFilesOfTheirKind) {
  EXPECT_NE(written(curves_report("a.vtp"), empty_run()).find("NumberOfPoints=\"0\""),
            std::string::npos);
  EXPECT_EQ(count_of(written(curves_report("a.obj"), empty_run()), "\n"), 1U);
  EXPECT_TRUE(
      nlohmann::json::parse(written(curves_report("a.mrk.json"), empty_run()))["markups"].empty());
}

TEST(ReportCurves, OtherExtensionsAreRefused) {
  EXPECT_THROW(curves_report("loops.json"), InvalidArgument);
  EXPECT_THROW(curves_report("loops"), InvalidArgument);
}

}  // namespace
}  // namespace isoloop
