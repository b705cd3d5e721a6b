#include "tools/runs/run_result.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/sample_run.h"

namespace isoloop {
namespace {

TEST(SelectLoops, KeepsOrderAndIds) {
  std::vector<Loop> loops = torus_run().analysis.loops;
  loops.insert(loops.begin() + 1, loops[0]);
  loops[0].size = 0.5;
  loops[1].id = 2;
  const std::vector<Loop> selected = select_loops(loops, {.min_size = 1.0});
  ASSERT_EQ(selected.size(), 2U);
  EXPECT_EQ(selected[0].id, 2);
  EXPECT_EQ(selected[1].kind, LoopKind::tunnel);
}

TEST(SelectLoops, KeepsInfiniteSizeUnlessABoundIsGiven) {
  const std::vector<Loop> loops = torus_run().analysis.loops;
  EXPECT_EQ(select_loops(loops, {}).size(), 2U);
  EXPECT_EQ(select_loops(loops, {.max_size = 1e9}).size(), 1U);
}

TEST(SelectLoops, KeepsOneSide) {
  const std::vector<Loop> loops = torus_run().analysis.loops;
  const std::vector<Loop> handles = select_loops(loops, {.tunnels = false});
  ASSERT_EQ(handles.size(), 1U);
  EXPECT_EQ(handles[0].kind, LoopKind::handle);
  const std::vector<Loop> tunnels = select_loops(loops, {.handles = false});
  ASSERT_EQ(tunnels.size(), 1U);
  EXPECT_EQ(tunnels[0].kind, LoopKind::tunnel);
}

TEST(PeakResidentBytes, IsMoreThanAMebibyte) { EXPECT_GT(peak_resident_bytes(), 1U << 20); }

TEST(CheckCounts, AcceptsATorus) { EXPECT_NO_THROW(check_counts(torus_run().analysis)); }

TEST(CheckCounts, RefusesAComponentWithABorder) {
  Analysis analysis = torus_run().analysis;
  analysis.surface.components[0].euler = 1;
  EXPECT_THROW(check_counts(analysis), SelfCheckFailed);
}

TEST(CheckCounts, RefusesBettiNumbersThatDisagree) {
  Analysis analysis = torus_run().analysis;
  analysis.betti.b1 = 2;
  EXPECT_THROW(check_counts(analysis), SelfCheckFailed);
}

TEST(CheckLoops, AcceptsATorus) { EXPECT_NO_THROW(check_loops(torus_run().analysis)); }

TEST(CheckLoops, AcceptsAnEmptySurface) { EXPECT_NO_THROW(check_loops(Analysis{})); }

TEST(CheckLoops, OfAnOpenSurfaceAreAsManyAsItsIndependentOnes) {
  Analysis analysis = open_run().analysis;
  EXPECT_NO_THROW(check_counts(analysis));
  EXPECT_NO_THROW(check_loops(analysis));
  analysis.loops.clear();
  EXPECT_THROW(check_loops(analysis), SelfCheckFailed);
}

TEST(CheckCounts, RefusesBordersThatContradictTheEulerCharacteristic) {
  Analysis analysis = open_run().analysis;
  analysis.surface.components[0].borders = 1;
  EXPECT_THROW(check_counts(analysis), SelfCheckFailed);
}

TEST(CheckCounts, RefusesBettiNumbersOfAnOpenSurfaceThatDisagree) {
  Analysis analysis = open_run().analysis;
  analysis.betti.b1 = 0;
  EXPECT_THROW(check_counts(analysis), SelfCheckFailed);
}

TEST(CheckLoops, RefusesASideForALoopOfAnOpenSurface) {
  Analysis analysis = open_run().analysis;
  analysis.loops[0].certificate.trivial_inside = true;
  EXPECT_THROW(check_loops(analysis), SelfCheckFailed);
}

TEST(CheckLoops, RefusesAMissingLoop) {
  Analysis analysis = torus_run().analysis;
  analysis.loops.pop_back();
  EXPECT_THROW(check_loops(analysis), SelfCheckFailed);
}

TEST(CheckLoops, RefusesAStepThatIsNoEdge) {
  Analysis analysis = torus_run().analysis;
  analysis.surface.triangles.erase(analysis.surface.triangles.begin(),
                                   analysis.surface.triangles.begin() + 6);
  EXPECT_THROW(check_loops(analysis), SelfCheckFailed);
}

TEST(CheckLoops, RefusesAVertexThatDoesNotExist) {
  Analysis analysis = torus_run().analysis;
  analysis.loops[0].curves[0][1] = 9;
  EXPECT_THROW(check_loops(analysis), SelfCheckFailed);
}

TEST(CheckLoops, RefusesAGeodesicThatCrossesNoEdge) {
  Analysis analysis = torus_run().analysis;
  Loop& handle = analysis.loops[0];
  handle.geodesics = {{{{0, 1}, 0.5}, {{1, 2}, 0.5}, {{2, 0}, 0.5}}};
  EXPECT_NO_THROW(check_loops(analysis));
  handle.geodesics[0][1].edge = {4, 2};  // pushed to the same vertex as before
  EXPECT_THROW(check_loops(analysis), SelfCheckFailed);
}

TEST(CheckLoops, RefusesTheCertificateOfTheOtherKind) {
  Analysis analysis = torus_run().analysis;
  analysis.loops[0].certificate = analysis.loops[1].certificate;
  EXPECT_THROW(check_loops(analysis), SelfCheckFailed);
}

}  // namespace
}  // namespace isoloop
