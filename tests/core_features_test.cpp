#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/analysis.h"
#include "core/features.h"
#include "tests/core_fixture.h"
#include "tests/random_volumes.h"

namespace isoloop {
namespace {

using testing::SmallVolume;
using testing::zero_level;

/// A plate across z, 2 * half_thickness thick, with a bore of the given radius in its middle.
SmallVolume bored_plate(double radius, double half_thickness) {
  SmallVolume volume;
  volume.dims = {40, 40, 24};
  for (int z = 0; z < 24; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        const double from_axis = std::hypot(x - 19.5, y - 19.5);
        volume.values.push_back(
            std::min({from_axis - radius, half_thickness - std::abs(z - 11.5), 17.0 - from_axis}));
      }
  return volume;
}

TEST(Features, SweepABoreFromMouthToMouth) {
  const SmallVolume volume = bored_plate(5.0, 7.0);
  const Analysis analysis = find_loops(volume.view(), zero_level);
  ASSERT_EQ(analysis.loops.size(), 2U);
  const Loop& tunnel = analysis.loops[1];
  const Feature feature = features_of(analysis.surface, analysis.loops)[1];
  EXPECT_GT(std::abs(feature.axis[2]), 0.99);
  EXPECT_GE(feature.least_girth, 0.9 * 2 * std::numbers::pi * 5.0);
  EXPECT_LE(feature.least_girth, tunnel.length);
  EXPECT_GE(feature.mean_girth, feature.least_girth);
  EXPECT_LE(feature.mean_girth, 1.5 * tunnel.length);
  // The bore is 14 deep; each front goes on for half a radius, or more where it zigzags.
  EXPECT_GE(feature.depth, 13.0);
  EXPECT_LE(feature.depth, 26.0);
  EXPECT_GE(feature.area, 0.9 * 2 * std::numbers::pi * 5.0 * 14.0);
  EXPECT_LE(feature.area, 2.0 * 2 * std::numbers::pi * 5.0 * 14.0);
}

TEST(Features, ReachFartherWithAGreaterRatio) {
  const SmallVolume volume = bored_plate(4.0, 5.0);
  const Analysis analysis = find_loops(volume.view(), zero_level);
  const auto near = features_of(analysis.surface, analysis.loops, {.ratio = 1.3});
  const auto farther = features_of(analysis.surface, analysis.loops, {.ratio = 2.0});
  EXPECT_LT(near[1].area, farther[1].area);
  EXPECT_LT(near[1].depth, farther[1].depth);
  EXPECT_TRUE(std::includes(farther[1].vertices.begin(), farther[1].vertices.end(),
                            near[1].vertices.begin(), near[1].vertices.end()));
}

// On the ring's inner side the fronts have less far to go: they slant and get longer.
TEST(Features, OfARingsHandleReachHalfTheRing) {
  const SmallVolume volume = testing::torus({40, 40, 16}, 0.3, 0.1);
  const Analysis analysis = find_loops(volume.view(), zero_level);
  const Feature feature = features_of(analysis.surface, analysis.loops)[0];
  EXPECT_GE(feature.vertices.size(), analysis.surface.points.size() / 2);
}

TEST(Features, OfRandomLoopsAreFiniteAndHoldTheLoop) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    const SmallVolume volume = testing::smooth_noise({16, 16, 16}, seed, 2);
    const Analysis analysis = find_loops(volume.view(), zero_level);
    const std::vector<Feature> features = features_of(analysis.surface, analysis.loops);
    ASSERT_EQ(features.size(), analysis.loops.size());
    for (std::size_t i = 0; i < features.size(); ++i) {
      EXPECT_TRUE(std::isfinite(features[i].area + features[i].depth));
      EXPECT_GT(features[i].least_girth, 0.0);
      EXPECT_LE(features[i].least_girth, analysis.loops[i].length);
      for (const Curve& curve : analysis.loops[i].curves)
        for (const std::uint32_t vertex : curve)
          EXPECT_TRUE(
              std::binary_search(features[i].vertices.begin(), features[i].vertices.end(), vertex));
    }
  }
}

}  // namespace
}  // namespace isoloop
