#include "core/loops/features.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "core/base/errors.h"
#include "tests/oracles/random_volumes.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using testing::SmallVolume;
using testing::zero_level;

constexpr double pi = std::numbers::pi;

/// A plate across z, 2 * half_thickness thick, with a bore of the given radius in its middle.
SmallVolume bored_plate(double radius, double half_thickness) {
  return testing::sampled({40, 40, 24}, [=](double x, double y, double z) {
    const double from_axis = std::hypot(x - 19.5, y - 19.5);
    return std::min({from_axis - radius, half_thickness - std::abs(z - 11.5), 17.0 - from_axis});
  });
}

/// Two plates 16 apart, joined by a rod of radius 4 between their middles and by a wall at a side.
SmallVolume rod_between_plates() {
  return testing::sampled({44, 30, 28}, [](double x, double y, double z) {
    const double plates = std::max(z - 22.0, 6.0 - z);
    const double rod = 4.0 - std::hypot(x - 16.5, y - 14.5);
    const double wall = x - 36.0;
    const double box = std::min({x - 1.5, 41.5 - x, y - 1.5, 27.5 - y, z - 1.5, 25.5 - z});
    return std::min(std::max({plates, rod, wall}), box);
  });
}

struct Features {
  explicit Features(const SmallVolume& volume, double ratio = FeatureOptions{}.ratio,
                    const Vec3& spacing = {1.0, 1.0, 1.0})
      : analysis(analyze(GridView<double>{volume.values, volume.dims, spacing}, zero_level)),
        all(features_of(analysis.surface, analysis.loops, {.ratio = ratio})) {}

  const Loop& loop(LoopKind kind) const { return analysis.loops[place(kind)]; }
  const Feature& of(LoopKind kind) const { return all[place(kind)]; }

  std::size_t place(LoopKind kind) const {
    return kind == LoopKind::handle ? 0 : analysis.loops.size() / 2;
  }

  Analysis analysis;
  std::vector<Feature> all;
};

void expect_share(double value, double least, double wanted, double most) {
  EXPECT_GE(value, least * wanted);
  EXPECT_LE(value, most * wanted);
}

TEST(Features, OfABoreReachFromMouthToMouth) {
  const Features features(bored_plate(5.0, 7.0));
  ASSERT_EQ(features.all.size(), 2U);
  const Feature& bore = features.of(LoopKind::tunnel);
  EXPECT_GT(bore.axis[2], 0.999);
  expect_share(bore.depth, 0.95, 14.0, 1.05);
  expect_share(bore.least_girth, 0.97, 2 * pi * 5.0, 1.03);
  expect_share(bore.thickness(), 0.97, 10.0, 1.03);
  expect_share(bore.area, 1.0, 2 * pi * 5.0 * 14.0, 1.6);
}

TEST(Features, OfARodReachFromRootToRoot) {
  const Features features(rod_between_plates());
  ASSERT_EQ(features.all.size(), 2U);
  const Feature& rod = features.of(LoopKind::handle);
  EXPECT_GT(rod.axis[2], 0.99);
  expect_share(rod.depth, 0.95, 16.0, 1.05);
  expect_share(rod.thickness(), 0.95, 8.0, 1.05);
}

TEST(Features, OfARingsHandleAreTheWholeRing) {
  const double ring = 0.8 * 24;
  const double tube = 0.2 * 24;
  const Features features(testing::torus({60, 60, 24}, 0.8, 0.2));
  const Feature& handle = features.of(LoopKind::handle);
  EXPECT_EQ(handle.vertices.size(), features.analysis.surface.points.size());
  expect_share(handle.area, 0.98, 4 * pi * pi * ring * tube, 1.02);
  expect_share(handle.depth, 0.9, 2 * pi * ring, 1.1);
  expect_share(handle.least_girth, 0.97, 2 * pi * tube, 1.03);
  EXPECT_LT(handle.axis[2], 0.1) << "the loop stands upright";
}

// Along the tube's top and bottom the girth is 1.5 times that of the loop.
TEST(Features, OfARingsTunnelEndWhereTheGirthHasGrown) {
  const Features features(testing::torus({48, 48, 48}, 0.3, 0.1), 1.5);
  const Feature& tunnel = features.of(LoopKind::tunnel);
  EXPECT_GT(tunnel.axis[2], 0.999);
  expect_share(tunnel.depth, 0.9, 2 * 4.8, 1.05);
  expect_share(tunnel.least_girth, 0.97, 2 * pi * 9.6, 1.03);
  EXPECT_GT(tunnel.mean_girth, 1.1 * tunnel.least_girth);
}

TEST(Features, ReachFartherWithAGreaterRatio) {
  const SmallVolume volume = bored_plate(4.0, 5.0);
  const Features near(volume, 1.3);
  const Features farther(volume, 2.0);
  const Feature& less = near.of(LoopKind::tunnel);
  const Feature& more = farther.of(LoopKind::tunnel);
  EXPECT_LT(less.area, more.area);
  EXPECT_LT(less.mean_girth, more.mean_girth);
  EXPECT_LT(less.vertices.size(), more.vertices.size());
  EXPECT_TRUE(std::includes(more.vertices.begin(), more.vertices.end(), less.vertices.begin(),
                            less.vertices.end()));
}

TEST(Features, WithoutALimitAreTheWholeComponent) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    const Features features(testing::smooth_noise({14, 14, 14}, seed, 2), 1e9);
    const Surface& surface = features.analysis.surface;
    for (std::size_t i = 0; i < features.all.size(); ++i) {
      const Loop& loop = features.analysis.loops[i];
      if (loop.curves.size() > 1) continue;
      std::vector<std::uint32_t> component;
      for (std::uint32_t v = 0; v < surface.points.size(); ++v)
        if (surface.component_of_vertex[v] == loop.component) component.push_back(v);
      EXPECT_EQ(features.all[i].vertices, component);
    }
  }
}

TEST(Features, AreInTheUnitOfTheSpacing) {
  const SmallVolume volume = bored_plate(5.0, 7.0);
  const Features voxels(volume);
  const Features halves(volume, 1.5, {0.5, 0.5, 0.5});
  const Feature& a = voxels.of(LoopKind::tunnel);
  const Feature& b = halves.of(LoopKind::tunnel);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_NEAR(a.area, 4 * b.area, 1e-6 * a.area);
  EXPECT_NEAR(a.depth, 2 * b.depth, 1e-6 * a.depth);
  EXPECT_NEAR(a.mean_girth, 2 * b.mean_girth, 1e-6 * a.mean_girth);
}

// Voxels twice as long along z: the bore is 28 deep and as wide as before.
TEST(Features, OfLongVoxelsAreMeasuredInTheWorld) {
  const Features features(bored_plate(5.0, 7.0), 1.5, {1.0, 1.0, 2.0});
  const Feature& bore = features.of(LoopKind::tunnel);
  expect_share(bore.depth, 0.95, 28.0, 1.05);
  expect_share(bore.thickness(), 0.97, 10.0, 1.03);
}

TEST(Features, OfRandomLoopsHoldTheLoopAndAreNoWiderThanIt) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Features features(testing::smooth_noise({16, 16, 16}, seed, 2));
    ASSERT_EQ(features.all.size(), features.analysis.loops.size());
    for (std::size_t i = 0; i < features.all.size(); ++i) {
      const Feature& feature = features.all[i];
      const Loop& loop = features.analysis.loops[i];
      EXPECT_TRUE(std::isfinite(feature.area + feature.depth));
      EXPECT_GT(feature.least_girth, 0.0);
      EXPECT_LE(feature.least_girth, loop.length);
      EXPECT_GE(feature.mean_girth, feature.least_girth);
      EXPECT_LE(feature.mean_girth, 1.5 * loop.length);
      EXPECT_NEAR(std::hypot(feature.axis[0], feature.axis[1], feature.axis[2]), 1.0, 1e-9);
      EXPECT_TRUE(std::is_sorted(feature.vertices.begin(), feature.vertices.end()));
      for (const Curve& curve : loop.curves)
        for (const std::uint32_t vertex : curve)
          EXPECT_TRUE(std::binary_search(feature.vertices.begin(), feature.vertices.end(), vertex));
    }
  }
}

TEST(Features, AskForRoomBeforeTheyTakeIt) {
  const Features features(bored_plate(5.0, 7.0));
  const Analysis& analysis = features.analysis;
  const auto with = [&](std::uint64_t bytes) {
    return features_of(analysis.surface, analysis.loops, {.max_bytes = bytes});
  };
  const std::uint64_t searching = 170 * analysis.surface.points.size();
  std::uint64_t kept = 0;
  for (const Feature& feature : features.all) kept += 4 * feature.vertices.size();
  EXPECT_THROW(with(searching - 1), LimitExceeded);
  EXPECT_THROW(with(searching + kept - 1), LimitExceeded);
  EXPECT_EQ(with(searching + kept).size(), 2U);
}

TEST(Features, OfALoopAloneAreThoseAmongMany) {
  const Features features(testing::white_noise({10, 10, 10}, 3));
  ASSERT_GT(features.all.size(), 20U);
  for (std::size_t i = 0; i < features.all.size(); ++i) {
    const Feature alone =
        features_of(features.analysis.surface, {features.analysis.loops[i]}).front();
    EXPECT_EQ(alone.vertices, features.all[i].vertices);
    EXPECT_EQ(alone.area, features.all[i].area);
    EXPECT_EQ(alone.depth, features.all[i].depth);
    EXPECT_EQ(alone.mean_girth, features.all[i].mean_girth);
  }
}

}  // namespace
}  // namespace isoloop
