#include "tools/reports/report_surface.h"

#include <cstdint>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/sample_run.h"

namespace isoloop {
namespace {

TEST(ReportSurface, ObjHasVerticesAndFaces) {
  const std::string obj = written(surface_report("a.obj"), torus_run());
  EXPECT_TRUE(obj.starts_with("# isoloop: frame world, spacing 0.5 0.5 0.5")) << obj;
  EXPECT_NE(obj.find("\nv 104.5 2.5 2.5\n"), std::string::npos) << obj;
  EXPECT_NE(obj.find("\nf 1 4 5\n"), std::string::npos) << obj;
}

TEST(ReportSurface, StlHasAHeadOf80BytesAnd50ForEachTriangle) {
  const std::string stl = written(surface_report("a.stl"), torus_run());
  ASSERT_EQ(stl.size(), 84U + 18 * 50);
  EXPECT_TRUE(stl.starts_with("isoloop: frame world"));
  std::uint32_t count = 0;
  std::memcpy(&count, stl.data() + 80, 4);
  EXPECT_EQ(count, 18U);
  float normal[3];
  std::memcpy(normal, stl.data() + 84, 12);
  EXPECT_NEAR(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2], 1.0, 1e-5);
}

TEST(ReportSurface, VtpSaysHowMuchItHolds) {
  const std::string vtp = written(surface_report("a.vtp"), torus_run());
  EXPECT_NE(vtp.find("NumberOfPoints=\"9\" NumberOfPolys=\"18\""), std::string::npos);
  EXPECT_NE(vtp.find("<!-- isoloop: frame world"), std::string::npos);
}

TEST(ReportSurface, PlyHoldsNoTubes) {
  const std::string ply = written(surface_report("a.ply"), torus_run());
  EXPECT_NE(ply.find("element vertex 9\n"), std::string::npos) << ply.substr(0, 500);
  EXPECT_NE(ply.find("element face 18\n"), std::string::npos);
}

TEST(ReportSurface, TurnsTrianglesOverWhereTheFrameMirrors) {
  LoopsRun run = torus_run();
  run.volume.direction[0] = {-1, 0, 0};
  EXPECT_NE(written(surface_report("a.obj"), run).find("\nf 1 5 4\n"), std::string::npos);
}

TEST(ReportSurface, OtherExtensionsAreRefused) {
  EXPECT_THROW(surface_report("surface.vtk"), InvalidArgument);
}

}  // namespace
}  // namespace isoloop
