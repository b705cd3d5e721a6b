#include "core/loops/pair_loops.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "core/loops/certificate.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

AnalysisOptions pair_options(Refinement refinement) {
  AnalysisOptions options;
  options.engine = Engine::pair;
  options.tighten = Tighten::none;
  options.pair.refinement = refinement;
  return options;
}

TEST(PairLoops, AreProvedUnderEveryRefinement) {
  for (const Refinement refinement :
       {Refinement::none, Refinement::first, Refinement::second, Refinement::both})
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      const testing::SmallVolume volume = testing::white_noise({8, 8, 8}, seed);
      // analyze() throws unless every loop is certified.
      const Analysis analysis =
          analyze(volume.view(), testing::zero_level, pair_options(refinement));
      const auto genus = static_cast<std::size_t>(analysis.surface.genus());
      EXPECT_EQ(analysis.loops.size(), 2 * genus);
      EXPECT_EQ(analysis.pairs.size(), 2 * genus);
    }
}

TEST(PairLoops, AreNumberedBySizeWithinTheirKind) {
  const testing::SmallVolume volume = testing::smooth_noise({14, 14, 14}, 5, 1);
  const Analysis analysis =
      analyze(volume.view(), testing::zero_level, pair_options(Refinement::first));
  const std::size_t genus = analysis.loops.size() / 2;
  ASSERT_GT(genus, 2U);
  for (std::size_t i = 0; i < analysis.loops.size(); ++i) {
    const Loop& loop = analysis.loops[i];
    EXPECT_EQ(loop.kind, i < genus ? LoopKind::handle : LoopKind::tunnel);
    EXPECT_EQ(loop.id, static_cast<int>(i % genus) + 1);
    if (i % genus > 0) {
      EXPECT_LE(analysis.loops[i - 1].size, loop.size);
    }
  }
}

TEST(PairLoops, OfATorusGoRoundTheTubeAndRoundTheHole) {
  const testing::SmallVolume volume = testing::torus({24, 24, 24});
  const Analysis analysis =
      analyze(volume.view(), testing::zero_level, pair_options(Refinement::both));
  ASSERT_EQ(analysis.loops.size(), 2U);
  // The tube is about 2 pi 2.9 = 18 round, the hole 2 pi 3.8 = 24. Killed cycles are not tight.
  EXPECT_GT(analysis.loops[0].length, 17.0);
  EXPECT_GT(analysis.loops[1].length, 22.0);
  EXPECT_LT(analysis.loops[0].length, 3 * 18.0);
  EXPECT_LT(analysis.loops[1].length, 3 * 24.0);
}

TEST(PairLoops, HaveTheSizesOfTheOtherEngine) {
  const testing::SmallVolume volume = testing::smooth_noise({14, 14, 14}, 6, 1);
  const Analysis dual = analyze(volume.view(), testing::zero_level);
  const Analysis pair = analyze(volume.view(), testing::zero_level, pair_options(Refinement::both));
  ASSERT_EQ(dual.loops.size(), pair.loops.size());
  for (std::size_t i = 0; i < dual.loops.size(); ++i)
    EXPECT_EQ(dual.loops[i].size, pair.loops[i].size);
  EXPECT_TRUE(dual.pairs.empty());
}

/// The total length of the loops of a kind.
double total_length(const testing::SmallVolume& volume, LoopKind kind, Refinement refinement) {
  double sum = 0.0;
  for (const Loop& loop :
       analyze(volume.view(), testing::zero_level, pair_options(refinement)).loops)
    sum += loop.kind == kind ? loop.length : 0.0;
  return sum;
}

/// The order off M is the same, and so are the cycles that are met.
TEST(PairLoops, AreNoLongerWithTheFirstRefinementThanWithoutIt) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const testing::SmallVolume volume = seed % 2 == 0 ? testing::white_noise({6, 7, 6}, seed)
                                                      : testing::smooth_noise({10, 11, 9}, seed, 1);
    for (const LoopKind kind : {LoopKind::handle, LoopKind::tunnel}) {
      EXPECT_LE(total_length(volume, kind, Refinement::first),
                total_length(volume, kind, Refinement::none) + 1e-6);
      EXPECT_LE(total_length(volume, kind, Refinement::both),
                total_length(volume, kind, Refinement::second) + 1e-6);
    }
  }
}

TEST(PairLoops, OfTheseVolumesAreNoLongerWithBothRefinementsThanWithNone) {
  const std::vector<testing::SmallVolume> shapes{testing::torus({24, 24, 24}),
                                                 testing::torus({30, 31, 29}, 0.3, 0.08),
                                                 testing::torus_shell({28, 28, 28}),
                                                 testing::linked_tori({28, 28, 28}),
                                                 testing::smooth_noise({18, 18, 18}, 1, 1),
                                                 testing::smooth_noise({20, 20, 20}, 2, 2)};
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (const LoopKind kind : {LoopKind::handle, LoopKind::tunnel})
      EXPECT_LE(total_length(shapes[i], kind, Refinement::both),
                total_length(shapes[i], kind, Refinement::none) + 1e-6)
          << "shape " << i;
}

TEST(PairLoops, OfASphereAreNone) {
  const testing::SmallVolume volume = testing::from_bits({1, 1, 1}, 1);
  const Analysis analysis =
      analyze(volume.view(), testing::zero_level, pair_options(Refinement::both));
  EXPECT_TRUE(analysis.loops.empty());
  EXPECT_TRUE(analysis.pairs.empty());
}

}  // namespace
}  // namespace isoloop
