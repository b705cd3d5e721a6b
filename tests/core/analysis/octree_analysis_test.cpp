#include <array>
#include <atomic>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "core/analysis/analysis.h"
#include "core/base/threads.h"
#include "tests/samples/octree_fixture.h"

namespace isoloop {
namespace {

using testing::SmallVolume;

constexpr std::array topologies{Topology::trilinear, Topology::simple, Topology::connected_6,
                                Topology::connected_18, Topology::connected_26};

/// A volume of with_room() with rules of its own, as the seed has it.
struct Setting {
  SmallVolume volume;
  GridView<double> view;
  IsoLevel level = testing::zero_level;
  AnalysisOptions options;

  explicit Setting(std::uint32_t seed) : volume(testing::with_room(seed)), view(volume.view()) {
    view.spacing = {1.0 + seed / 2 % 2, 1.0, 1.0 + seed / 4 % 4 * 0.8};
    level.topology = topologies[seed % topologies.size()];
    options.boundary = seed % 7 < 2 ? Boundary::open : Boundary::closed;
    options.engine = seed % 11 == 0 ? Engine::pair : Engine::dual;
    options.grading = static_cast<int>(seed / 3 % 3);
    options.tighten = Tighten::none;
  }

  Analysis with(ComplexKind complex) const {
    AnalysisOptions asked = options;
    asked.complex = complex;
    return analyze(view, level, asked);
  }
};

bool are_same(const Analysis& a, const Analysis& b) {
  if (a.loops.size() != b.loops.size()) return false;
  for (std::size_t i = 0; i < a.loops.size(); ++i)
    if (a.loops[i].kind != b.loops[i].kind || a.loops[i].size != b.loops[i].size ||
        a.loops[i].length != b.loops[i].length || a.loops[i].curves != b.loops[i].curves)
      return false;
  return true;
}

TEST(OctreeAnalysis, FindsAndProvesAsManyLoopsOfEachKindAsTheGridWhateverTheRules) {
  std::atomic<std::size_t> compared = 0;
  tbb::parallel_for(std::uint32_t{0}, std::uint32_t{300}, [&](std::uint32_t seed) {
    const Setting setting(seed);
    const Analysis grid = setting.with(ComplexKind::grid);
    const Analysis octree = setting.with(ComplexKind::octree);
    if (grid.surface.betti1() == 0) return;
    EXPECT_EQ(grid.complex, ComplexKind::grid);
    EXPECT_EQ(octree.complex, ComplexKind::octree);
    EXPECT_EQ(octree.betti.b1, grid.betti.b1) << "volume " << seed;
    ASSERT_EQ(octree.loops.size(), grid.loops.size()) << "volume " << seed;
    for (std::size_t i = 0; i < grid.loops.size(); ++i)
      EXPECT_EQ(octree.loops[i].kind, grid.loops[i].kind);
    compared += grid.loops.size();
  });
  EXPECT_GT(compared, 600U);
}

TEST(OctreeAnalysis, IsTheSameForAnyNumberOfThreads) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const Setting setting(seed);
    const Analysis one = with_threads(1, [&] { return setting.with(ComplexKind::octree); });
    for (const int threads : {2, 7}) {
      const Analysis more =
          with_threads(threads, [&] { return setting.with(ComplexKind::octree); });
      ASSERT_TRUE(are_same(one, more)) << "volume " << seed << ", " << threads << " threads";
    }
  }
}

TEST(OctreeAnalysis, TakesTheOctreeByItselfInALargeBoxAlone) {
  SmallVolume volume = testing::torus({24, 24, 16});
  EXPECT_EQ(analyze(volume.view(), testing::zero_level).complex, ComplexKind::grid);
  volume = testing::sampled({96, 96, 96}, [&](double x, double y, double z) {
    const bool is_far = x == 0 && y == 0 && z == 0;
    if (is_far || (x == 95 && y == 95 && z == 95)) return 1.0;
    if (x < 40 || x >= 64 || y < 40 || y >= 64 || z < 40 || z >= 56) return -1.0;
    return volume.values[static_cast<std::size_t>((x - 40) + 24 * ((y - 40) + 24 * (z - 40)))];
  });
  const Analysis analysis = analyze(volume.view(), testing::zero_level);
  EXPECT_EQ(analysis.complex, ComplexKind::octree);
  EXPECT_EQ(analysis.loops.size(), 2U);
}

}  // namespace
}  // namespace isoloop
