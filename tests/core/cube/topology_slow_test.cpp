// Trilinear topology at size, against refined cubes: minutes, so not among the default tests.
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "tests/oracles/cube_ties.h"
#include "tests/oracles/cut_of_levels.h"
#include "tests/oracles/refined_field.h"
#include "tests/oracles/tied_volumes.h"

namespace isoloop {
namespace {

TEST(TopologySlow, AMillionCubesHaveThePartsOfTheRefinedCubes) {
  const testing::CubeComparison comparison = testing::compare_with_refined_cubes(1'000'000, 7);
  EXPECT_EQ(comparison.wrong, 0);
  EXPECT_GT(comparison.tunnels, 3000);
  EXPECT_LT(comparison.unresolved, 1000);
  std::printf(
      "%d cubes: %d have a tunnel, %d are too fine for voxels, %d look otherwise at 8 and 16 steps "
      "than at more, %d differ\n",
      comparison.cubes, comparison.tunnels, comparison.unresolved, comparison.misled,
      comparison.wrong);
}

TEST(TopologySlow, AllCubesOfFiveLevelsObeyTheRuleForTies) {
  const testing::TiedCubes found = testing::check_all_cubes(5);
  EXPECT_EQ(found.cubes, 390'625);
  EXPECT_EQ(found.against_the_rule, 0);
  EXPECT_EQ(found.against_the_sweep, 0);
  EXPECT_EQ(found.off_the_cube + found.crossings + found.without_area, 0);
  std::printf("%d cubes of five levels: %d have a tunnel\n", found.cubes, found.tunnels);
}

TEST(TopologySlow, AMillionCubesOfSmallNumbersHaveVerticesWithinAndNoCrossing) {
  std::mt19937 random(17);
  testing::TiedCubes found;
  for (int i = 0; i < 1'000'000; ++i) {
    CornerLevels levels{};
    for (double& level : levels) level = static_cast<double>(random() % 17) - 8;
    testing::check_geometry(levels, found);
  }
  EXPECT_EQ(found.off_the_cube + found.crossings + found.without_area, 0);
  std::printf("%d cubes of small numbers: %d have a tunnel\n", found.cubes, found.tunnels);
}

TEST(TopologySlow, TwentyThousandVolumesOfFewLevelsAreCountedRightAndAllTheirLoopsAreMeasured) {
  std::size_t loops = 0;
  for (std::uint32_t seed = 1000; seed < 21'000; ++seed)
    EXPECT_EQ(testing::complaint_about(testing::tied_volume(seed), loops), "") << "volume " << seed;
  std::printf("20000 volumes of few levels: %zu loops\n", loops);
}

struct FieldKind {
  std::int64_t size;  // voxels along each axis
  double sigma;       // of the Gaussian that white noise is smoothed by; voxels
};

class GaussianFields : public ::testing::TestWithParam<FieldKind> {};

TEST_P(GaussianFields, BoundSolidsOfTheRefinedEulerCharacteristic) {
  const auto& [size, sigma] = GetParam();
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const testing::SmallVolume volume = testing::gaussian_field({size, size, size}, sigma, seed);
    const testing::RefinedEuler expected = testing::refined_euler(volume);
    EXPECT_LT(1000 * expected.unresolved, expected.cubes);
    const auto euler_of = [&](Topology topology) {
      const IsoLevel level{0.0, InsideRule::above, topology};
      return count_topology(volume.view(), level).surface.euler() / 2;
    };
    EXPECT_EQ(euler_of(Topology::trilinear), expected.euler) << sigma << " seed " << seed;
    std::printf(
        "%3d^3 sigma %g seed %2u: refined %6d (%d of %d cubes too fine for voxels), simple %d\n",
        static_cast<int>(size), sigma, seed, static_cast<int>(expected.euler),
        static_cast<int>(expected.unresolved), static_cast<int>(expected.cubes),
        static_cast<int>(euler_of(Topology::simple)));
    std::fflush(stdout);
  }
}

INSTANTIATE_TEST_SUITE_P(TopologySlow, GaussianFields,
                         ::testing::Values(FieldKind{64, 1.0}, FieldKind{64, 2.0},
                                           FieldKind{64, 4.0}, FieldKind{128, 1.0},
                                           FieldKind{128, 2.0}, FieldKind{128, 4.0}),
                         [](const auto& tested) {
                           return std::to_string(tested.param.size) + "Sigma" +
                                  std::to_string(static_cast<int>(tested.param.sigma));
                         });

}  // namespace
}  // namespace isoloop
