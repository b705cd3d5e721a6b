#include "core/surface/betti.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "core/analysis/analysis.h"
#include "core/cube/voxel_sides.h"
#include "tests/oracles/explicit_complex.h"
#include "tests/oracles/slow_reduction.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using testing::SmallVolume;
using testing::zero_level;

std::array<std::int64_t, 3> counted(const SmallVolume& volume) {
  const Betti betti = count_topology(volume.view(), zero_level).betti;
  return {betti.b0, betti.b1, betti.b2};
}

std::array<std::int64_t, 3> by_ranks(const SmallVolume& volume) {
  const VoxelSides sides = classify(volume.view(), zero_level);
  if (sides.empty()) return {0, 0, 0};
  return oracle::betti_inside(
      oracle::build_complex(volume.values, volume.dims, sides.lattice, testing::walls_of(sides)));
}

/// Number of volumes that count differently.
int differences(int count, const std::function<SmallVolume(std::uint32_t)>& make) {
  std::atomic<int> different = 0;
  tbb::parallel_for(0, count, [&](int i) {
    const SmallVolume volume = make(static_cast<std::uint32_t>(i));
    if (counted(volume) != by_ranks(volume)) ++different;
  });
  return different;
}

TEST(Betti, EqualTheRanksOnAllBlocksOfTwoByTwoByThree) {
  EXPECT_EQ(differences(4096, [](std::uint32_t i) { return testing::from_bits({2, 2, 3}, i); }), 0);
}

/// A hundred thousand volumes in four tests, so that tests run beside each other share them.
class BettiOfThreeCubed : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(BettiOfThreeCubed, EqualTheRanksOnRandomBlocks) {
  EXPECT_EQ(differences(25'000,
                        [](std::uint32_t i) {
                          return testing::white_noise({3, 3, 3}, 25'000 * GetParam() + i);
                        }),
            0);
}

INSTANTIATE_TEST_SUITE_P(Quarter, BettiOfThreeCubed, ::testing::Range(0U, 4U));

TEST(Betti, EqualTheRanksOnLargerNoise) {
  EXPECT_EQ(differences(200,
                        [](std::uint32_t i) {
                          return testing::smooth_noise({9, 8, 7}, i, 1);
                        }),
            0);
}

TEST(Betti, TellCavitiesFromComponents) {
  EXPECT_EQ(counted(testing::torus_shell({24, 24, 24})), (std::array<std::int64_t, 3>{1, 2, 1}));
  EXPECT_EQ(counted(testing::linked_tori({28, 28, 28})), (std::array<std::int64_t, 3>{2, 2, 0}));
}

TEST(Betti, SurviveTheFortyEightSymmetries) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const SmallVolume volume = testing::white_noise({5, 6, 4}, seed);
    const auto expected = counted(volume);
    std::array<int, 3> permutation{0, 1, 2};
    do {
      for (int flips = 0; flips < 8; ++flips)
        ASSERT_EQ(counted(testing::transformed(
                      volume, permutation, {(flips & 1) != 0, (flips & 2) != 0, (flips & 4) != 0})),
                  expected);
    } while (std::next_permutation(permutation.begin(), permutation.end()));
  }
}

}  // namespace
}  // namespace isoloop
