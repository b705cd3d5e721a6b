// Cubes with corners and saddles at the iso value: few distinct values, as masks and label maps
// have.
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/oracles/cube_ties.h"
#include "tests/oracles/tied_volumes.h"

namespace isoloop {
namespace {

using testing::TiedCubes;

TEST(CubeTies, AllCubesOfThreeLevelsObeyTheRule) {
  const TiedCubes found = testing::check_all_cubes(3);
  EXPECT_EQ(found.cubes, 6561);
  EXPECT_GT(found.tunnels, 20);
  EXPECT_EQ(found.against_the_rule, 0);
  EXPECT_EQ(found.against_the_sweep, 0);
  EXPECT_EQ(found.off_the_cube, 0);
  EXPECT_EQ(found.crossings, 0);
  EXPECT_EQ(found.without_area, 0);
}

TEST(CubeTies, RandomCubesOfFiveLevelsObeyTheRule) {
  std::mt19937 random(1);
  TiedCubes found;
  for (int i = 0; i < 27'000; ++i) {
    CornerLevels levels{};
    for (double& level : levels) level = static_cast<double>(random() % 5) - 2;
    testing::check_cube(levels, found);
  }
  EXPECT_GT(found.tunnels, 400);
  EXPECT_EQ(found.against_the_rule, 0);
  EXPECT_EQ(found.against_the_sweep, 0);
  EXPECT_EQ(found.off_the_cube, 0);
  EXPECT_EQ(found.crossings, 0);
}

TEST(CubeTies, ACornerThatIsRaisedWeighsLessThanSeveralThatAreLowered) {
  // The discriminant vanishes, and does so still once the levels other than 0 are lowered alike.
  const CornerLevels levels{-2, -2, 1, 2, 0, 2, 0, -1};
  EXPECT_TRUE(testing::cut_of(levels).hub);
}

TEST(CubeTies, TrianglesOfACubeDoNotCrossWhateverItsLevels) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  TiedCubes found;
  for (int i = 0; i < 60'000; ++i) {
    CornerLevels levels{};
    // Magnitudes over several orders, so that vertices come close to corners.
    for (double& level : levels)
      level = (random() % 2 == 0 ? 1 : -1) * std::exp((i % 4) * normal(random));
    testing::check_geometry(levels, found);
  }
  EXPECT_GT(found.tunnels, 600);
  EXPECT_EQ(found.off_the_cube, 0);
  EXPECT_EQ(found.crossings, 0);
  EXPECT_EQ(found.without_area, 0);
}

TEST(Ties, VolumesOfFewLevelsAreCountedRightAndAllTheirLoopsAreMeasured) {
  std::size_t loops = 0;
  for (std::uint32_t seed = 0; seed < 600; ++seed)
    ASSERT_EQ(testing::complaint_about(testing::tied_volume(seed), loops), "") << "volume " << seed;
  EXPECT_GT(loops, 5000U);
}

}  // namespace
}  // namespace isoloop
