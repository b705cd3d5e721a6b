#include "core/loops/loops.h"

#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/loops/certificate.h"
#include "tests/oracles/basis_comparison.h"

namespace isoloop {
namespace {

using testing::SmallVolume;

struct Solved : testing::WithLoops {
  explicit Solved(const SmallVolume& volume) : WithLoops(volume), loops(all_loops()) {}
  std::vector<Loop> loops;  // all, handles first
};

TEST(Loops, AreCompleteAndCertifiedOnNoise) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    Solved solved(testing::white_noise({9, 10, 8}, seed));
    EXPECT_EQ(static_cast<std::int64_t>(solved.loops.size()), 2 * solved.prepared.surface.genus());
    for (const Loop& loop : certified(solved.prepared.surface, solved.classes, solved.loops)) {
      EXPECT_EQ(loop.certificate.trivial_inside, loop.kind == LoopKind::handle);
      EXPECT_EQ(loop.certificate.trivial_outside, loop.kind == LoopKind::tunnel);
      EXPECT_FALSE(loop.generators.empty());
    }
  }
}

TEST(Loops, OfATorusGoRoundTheTubeAndRoundTheHole) {
  // Ring radius 0.28 n, tube radius 0.12 n; paths along edges are a few per cent longer.
  const double n = 48;
  const Solved solved(testing::torus({48, 48, 48}));
  const double pi = 3.14159265358979;
  EXPECT_NEAR(testing::total_length(solved.handles) / (2 * pi * 0.12 * n), 1.05, 0.06);
  EXPECT_NEAR(testing::total_length(solved.tunnels) / (2 * pi * (0.28 - 0.12) * n), 1.05, 0.06);
  for (const Loop& loop : solved.loops) EXPECT_NEAR(loop.center_index[2], 23.5, 1.0);
}

TEST(Loops, EveryLoopOfATorusShellBoundsOnItsSide) {
  Solved solved(testing::torus_shell({32, 32, 32}));
  ASSERT_EQ(solved.loops.size(), 4U);
  EXPECT_NO_THROW(certified(solved.prepared.surface, solved.classes, solved.loops));
  // Within the shell a circle on the outer wall bounds only together with one on the inner wall.
  for (const Loop& loop : solved.loops) {
    EXPECT_EQ(loop.curves.size(), loop.kind == LoopKind::handle ? 2U : 1U);
    EXPECT_EQ(std::isinf(loop.size), loop.kind == LoopKind::handle);
  }
}

TEST(Loops, OfLinkedToriLieOnTheirOwnTorus) {
  Solved solved(testing::linked_tori({40, 40, 40}));
  ASSERT_EQ(solved.loops.size(), 4U);
  EXPECT_NO_THROW(certified(solved.prepared.surface, solved.classes, solved.loops));
  std::set<std::uint32_t> components;
  for (const Loop& loop : solved.loops)
    if (loop.kind == LoopKind::handle) components.insert(loop.component);
  EXPECT_EQ(components.size(), 2U);
}

TEST(Loops, LengthsAreThoseOfTheirCurves) {
  const Solved solved(testing::smooth_noise({16, 16, 16}, 3, 1));
  ASSERT_FALSE(solved.loops.empty());
  for (const Loop& loop : solved.loops) {
    double length = 0.0;
    for (const Curve& curve : loop.curves)
      for (std::size_t i = 0; i < curve.size(); ++i)
        length += distance(scaled_point(solved.prepared.surface, curve[i]),
                           scaled_point(solved.prepared.surface, curve[(i + 1) % curve.size()]));
    EXPECT_NEAR(loop.length, length, 1e-6 * length);
  }
}

TEST(Loops, ALoopOfTheWrongKindIsNotCertified) {
  Solved solved(testing::torus({20, 20, 20}));
  std::swap(solved.loops[0].curves, solved.loops[1].curves);
  EXPECT_THROW(certified(solved.prepared.surface, solved.classes, solved.loops), SelfCheckFailed);
}

TEST(Loops, ALoopReportedTwiceIsNotCertified) {
  Solved solved(testing::linked_tori({40, 40, 40}));
  ASSERT_EQ(solved.loops[0].kind, solved.loops[1].kind);
  solved.loops[0].curves = solved.loops[1].curves;
  EXPECT_THROW(certified(solved.prepared.surface, solved.classes, solved.loops), SelfCheckFailed);
}

TEST(Loops, AMissingLoopIsNoticed) {
  Solved solved(testing::linked_tori({40, 40, 40}));
  solved.loops.pop_back();
  EXPECT_THROW(certified(solved.prepared.surface, solved.classes, solved.loops), SelfCheckFailed);
}

TEST(Loops, ALoopThatLeavesTheSurfaceIsNotCertified) {
  Solved solved(testing::torus({24, 24, 24}));
  Curve& curve = solved.loops[0].curves[0];
  curve.erase(curve.begin() + 1, curve.begin() + 4);
  EXPECT_THROW(certified(solved.prepared.surface, solved.classes, solved.loops), SelfCheckFailed);
}

TEST(Loops, SayWhatTheSearchForEachOfThemTook) {
  Solved solved(testing::white_noise({9, 10, 8}, 3));
  const SearchedLoops found = solved.search_on(*solved.prepared.inside, solved.inside,
                                               solved.inside_borders, solved.inside_classes);
  ASSERT_GT(found.loops.size(), 10U);
  ASSERT_EQ(found.seconds.size(), found.loops.size());
  for (const double seconds : found.seconds) EXPECT_GT(seconds, 0.0);
}

TEST(Loops, TheSlowestHundredthIsOneSearchAtLeast) {
  EXPECT_EQ(slowest_hundredth({}), 0.0);
  EXPECT_EQ(slowest_hundredth({1.0, 4.0, 2.0}), 4.0);
  std::vector<double> seconds(200, 1.0);
  seconds[17] = 8.0;
  EXPECT_EQ(slowest_hundredth(seconds), 9.0);
  seconds.push_back(0.5);
  EXPECT_EQ(slowest_hundredth(seconds), 10.0);
}

}  // namespace
}  // namespace isoloop
