#include "core/tighten/straighten.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "core/base/threads.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

Analysis loops_of(const testing::SmallVolume& volume, Tighten tighten) {
  AnalysisOptions options;
  options.tighten = tighten;
  return analyze(volume.view(), testing::zero_level, options);
}

TEST(Straighten, KeepsTheClassOfEveryLoopOnHundredsOfVolumes) {
  int loops = 0;
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    const testing::SmallVolume volume = seed % 2 == 0 ? testing::white_noise({5, 6, 5}, seed)
                                                      : testing::smooth_noise({10, 9, 11}, seed, 1);
    // straightened() throws where a geodesic leaves the class of its curve.
    const Analysis analysis = loops_of(volume, Tighten::curve);
    for (const Loop& loop : analysis.loops) {
      ASSERT_EQ(loop.geodesics.size(), loop.curves.size());
      ++loops;
    }
  }
  EXPECT_GT(loops, 1500);
}

TEST(Straighten, MakesNoLoopLongerAndMeasuresItAnew) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const testing::SmallVolume volume = testing::smooth_noise({18, 17, 19}, seed, 2);
    const Analysis along_edges = loops_of(volume, Tighten::basis);
    const Analysis across = loops_of(volume, Tighten::curve);
    ASSERT_EQ(across.loops.size(), along_edges.loops.size());
    for (std::size_t i = 0; i < across.loops.size(); ++i) {
      const Loop& loop = across.loops[i];
      EXPECT_LE(loop.length, along_edges.loops[i].length);
      EXPECT_EQ(loop.curves, along_edges.loops[i].curves);
      EXPECT_EQ(loop.found_length, along_edges.loops[i].found_length);
      double length = 0.0;
      for (const std::vector<Vec3>& points : drawn_curves(across.surface, loop))
        for (std::size_t k = 0; k < points.size(); ++k)
          length += scaled_distance(across.surface, points[k], points[(k + 1) % points.size()]);
      EXPECT_DOUBLE_EQ(length, loop.length);
    }
  }
}

TEST(Straighten, DrawsTheLoopsOfATorusAsCircles) {
  // Ring of radius 0.3 and tube of radius 0.1 of the box, as testing::torus() makes it.
  const testing::SmallVolume volume = testing::torus({60, 60, 60}, 0.3, 0.1);
  const Analysis analysis = loops_of(volume, Tighten::curve);
  ASSERT_EQ(analysis.loops.size(), 2U);
  for (const Loop& loop : analysis.loops) EXPECT_EQ(loop.curves.size(), 1U);
  const double handle = analysis.loops[0].length;
  const double tunnel = analysis.loops[1].length;
  EXPECT_NEAR(tunnel / handle, 2.0, 0.04);  // (0.3 - 0.1) / 0.1
}

TEST(Straighten, IsTheSameForAnyNumberOfThreads) {
  const testing::SmallVolume volume = testing::smooth_noise({20, 21, 22}, 8, 2);
  std::vector<std::vector<Vec3>> centers;
  for (const int threads : {1, 2, 16}) {
    const Analysis analysis =
        with_threads(threads, [&] { return loops_of(volume, Tighten::curve); });
    centers.emplace_back();
    for (const Loop& loop : analysis.loops) centers.back().push_back(loop.center_index);
  }
  EXPECT_FALSE(centers[0].empty());
  EXPECT_EQ(centers[0], centers[1]);
  EXPECT_EQ(centers[0], centers[2]);
}

}  // namespace
}  // namespace isoloop
