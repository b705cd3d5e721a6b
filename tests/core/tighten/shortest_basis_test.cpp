#include "core/tighten/shortest_basis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/threads.h"
#include "tests/oracles/basis_comparison.h"

namespace isoloop {
namespace {

using testing::WithLoops;

TEST(ShortestBasis, IsNextToTheLeastOnSmallSurfaces) {
  testing::Tally tally;
  for (std::uint32_t seed = 0; tally.surfaces < 40; ++seed)
    if (const auto volume = testing::small_surface(seed))
      tally.add(testing::shortened_over_least(*volume));
  EXPECT_LE(tally.sum / tally.surfaces, 1.02);
  EXPECT_LE(tally.worst, 1.10);
  EXPECT_GE(tally.equal, 0.8 * tally.surfaces);
}

TEST(ShortestBasis, NeverGetsLongerHoweverSmallTheEffort) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const testing::SmallVolume volume = testing::smooth_noise({18, 17, 16}, seed, 1);
    double least = 0.0;
    for (const double effort : {1e7, 1e4, 100.0, 0.0}) {
      WithLoops loops(volume);
      const double handles = testing::total_length(loops.handles);
      const double tunnels = testing::total_length(loops.tunnels);
      loops.shorten({effort, 0.0});
      EXPECT_LE(testing::total_length(loops.handles), handles);
      EXPECT_LE(testing::total_length(loops.tunnels), tunnels);
      const std::vector<Loop> all = loops.all_loops();
      EXPECT_NO_THROW(certified(loops.prepared.surface, loops.classes, all));
      if (least == 0.0) least = testing::total_length(all);
      EXPECT_LE(loops.handle_bound + loops.tunnel_bound, least) << effort;
    }
  }
}

TEST(ShortestBasis, ProvesTheLoopsOfATorusShortest) {
  WithLoops loops(testing::torus({32, 32, 32}));
  loops.shorten();
  EXPECT_NEAR(loops.handle_bound / testing::total_length(loops.handles), 1.0, 1e-4);
  EXPECT_NEAR(loops.tunnel_bound / testing::total_length(loops.tunnels), 1.0, 1e-4);
}

TEST(ShortestBasis, EveryLoopClosesItsOwnHandle) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    WithLoops loops(testing::white_noise({9, 8, 9}, seed));
    const std::vector<Loop> found = loops.all_loops();
    loops.shorten();
    const std::vector<Loop> all = loops.all_loops();
    ASSERT_EQ(all.size(), found.size());
    for (std::size_t n = 0; n < all.size(); ++n) {
      const Loop& loop = all[n];
      const Side side = side_of(loop.kind);
      const auto set = class_of(loops.prepared.surface, loops.classes, loop.curves);
      const Z2Basis& borders = side == Side::inside ? loops.inside_classes : loops.outside_classes;
      const auto closes = borders.coordinates(split_class(loops.classes, side, set).other);
      EXPECT_EQ(std::count(closes->begin(), closes->end(), loop.id - 1), 1) << seed;
      EXPECT_EQ(loop.size, found[n].size);
      EXPECT_EQ(loop.id, found[n].id);
      EXPECT_EQ(loop.found_length, found[n].length);
    }
  }
}

TEST(ShortestBasis, KeepsLoopsOfSeveralCurves) {
  WithLoops loops(testing::torus_shell({32, 32, 32}));
  const double before = testing::total_length(loops.handles);
  loops.shorten();
  const std::vector<Loop> all = loops.all_loops();
  EXPECT_NO_THROW(certified(loops.prepared.surface, loops.classes, all));
  for (const Loop& loop : loops.handles) EXPECT_EQ(loop.curves.size(), 2U);
  EXPECT_LE(testing::total_length(loops.handles), before);
}

/// Bars along the edges of cubes of `period` voxels.
testing::SmallVolume lattice(std::int64_t size, double period) {
  const auto off = [period](double x) { return std::abs(std::remainder(x - 4.0, period)); };
  return testing::sampled({size, size, size}, [&](double x, double y, double z) {
    const std::array<double, 3> from{off(x), off(y), off(z)};
    const double along_two = std::min(
        {std::hypot(from[0], from[1]), std::hypot(from[1], from[2]), std::hypot(from[2], from[0])});
    return 0.15 * period - along_two;
  });
}

TEST(ShortestBasis, EndsThoughMoreLoopsAreOutOfReachThanItCanSearchFor) {
  WithLoops loops(lattice(87, 13.0));
  EXPECT_GT(loops.handles.size(), 200U);
  loops.shorten({3e6, 0.0});
  std::vector<Loop> all = loops.all_loops();
  EXPECT_NO_THROW(certified(loops.prepared.surface, loops.classes, all));
}

TEST(ShortestBasis, IsTheSameForAnyNumberOfThreads) {
  const testing::SmallVolume volume = testing::smooth_noise({30, 31, 32}, 8, 2);
  std::vector<std::vector<Curve>> curves;
  for (const int threads : {1, 2, 16}) {
    WithLoops loops(volume);
    with_threads(threads, [&] { loops.shorten(); });
    curves.emplace_back();
    for (const Loop& loop : loops.all_loops())
      curves.back().insert(curves.back().end(), loop.curves.begin(), loop.curves.end());
  }
  EXPECT_EQ(curves[0], curves[1]);
  EXPECT_EQ(curves[0], curves[2]);
}

}  // namespace
}  // namespace isoloop
