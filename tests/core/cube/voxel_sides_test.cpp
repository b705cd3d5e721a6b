#include "core/cube/voxel_sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/oracles/random_volumes.h"

namespace isoloop {
namespace {

constexpr IsoLevel above_half{0.5, InsideRule::above};

GridView<float> view_of(const std::vector<float>& values, const Index3& dims) {
  return {values, dims, {1, 1, 1}};
}

TEST(VoxelSides, TheIsoValueItselfIsInside) {
  const std::vector<float> values{0.5F};
  EXPECT_FALSE(classify(view_of(values, {1, 1, 1}), above_half).empty());
  EXPECT_FALSE(classify(view_of(values, {1, 1, 1}), IsoLevel{0.5, InsideRule::below}).empty());
  EXPECT_TRUE(classify(view_of(values, {1, 1, 1}), IsoLevel{0.51, InsideRule::above}).empty());
}

TEST(VoxelSides, TheBoxIsTheSolidsBoundingBoxAndOneLayer) {
  std::vector<float> values(10 * 8 * 6, 0.0F);
  values[3 + 10 * (2 + 8 * 5)] = 1.0F;
  values[4 + 10 * (4 + 8 * 5)] = 1.0F;
  const VoxelSides sides = classify(view_of(values, {10, 8, 6}), above_half);
  EXPECT_EQ(sides.lattice.first, (Index3{2, 1, 4}));
  EXPECT_EQ(sides.lattice.dims, (std::array<std::uint32_t, 3>{4, 5, 3}));
}

TEST(VoxelSides, NaNIsRefusedWithItsPlace) {
  std::vector<float> values(4 * 3 * 2, 1.0F);
  values[1 + 4 * (2 + 3 * 1)] = std::numeric_limits<float>::quiet_NaN();
  try {
    classify(view_of(values, {4, 3, 2}), above_half);
    FAIL() << "accepted";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.fault, Fault::not_finite);
    EXPECT_EQ(error.finding.place, "voxel (1, 2, 1)");
  }
}

TEST(VoxelSides, BetweenTwoIsoValuesIsInside) {
  const std::vector<float> values{0, 1, 2, 3, 4};
  const IsoLevel band{1.0, InsideRule::above, Topology::trilinear, 3.0};
  const VoxelSides sides = classify(view_of(values, {5, 1, 1}), band);
  EXPECT_EQ(sides.lattice.first[0], 0);
  EXPECT_EQ(sides.lattice.dims[0], 5U);
  const IsoLevel empty{1.0, InsideRule::above, Topology::trilinear, 0.5};
  const IsoLevel below{1.0, InsideRule::below, Topology::trilinear, 3.0};
  EXPECT_THROW(classify(view_of(values, {5, 1, 1}), empty), InvalidArgument);
  EXPECT_THROW(classify(view_of(values, {5, 1, 1}), below), InvalidArgument);
}

TEST(VoxelSides, ASpacingThatSinglePrecisionCannotHoldIsRefused) {
  const std::vector<float> values{1};
  for (const double length : {0.0, -1.0, 1e-45, 1e38, std::nan("")})
    EXPECT_THROW(classify(GridView<float>{values, {1, 1, 1}, {1, length, 1}}, above_half),
                 InvalidArgument)
        << length;
  for (const double length : {least_spacing, most_spacing})
    EXPECT_NO_THROW(classify(GridView<float>{values, {1, 1, 1}, {1, length, 1}}, above_half));
}

TEST(VoxelSides, ASolidTooFarOutForSinglePrecisionIsRefused) {
  std::vector<std::uint8_t> values((std::size_t{1} << 20) + 2);
  values[values.size() - 3] = 1;
  const auto dims = Index3{static_cast<std::int64_t>(values.size()), 1, 1};
  EXPECT_THROW(classify(GridView<std::uint8_t>{values, dims}, above_half), LimitExceeded);
  std::swap(values[0], values[values.size() - 3]);
  EXPECT_NO_THROW(classify(GridView<std::uint8_t>{values, dims}, above_half));
}

TEST(VoxelSides, InfiniteValuesAreVeryLargeOnes) {
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<float> values{inf, -inf, -inf, inf};
  const VoxelSides sides = classify(view_of(values, {2, 2, 1}), above_half);
  EXPECT_EQ(sides.lattice.dims, (std::array<std::uint32_t, 3>{4, 4, 3}));
}

TEST(VoxelSides, ADimensionThatDoesNotFitIsRefused) {
  const std::vector<float> values(7, 1.0F);
  EXPECT_THROW(classify(view_of(values, {2, 2, 2}), above_half), InvalidArgument);
  EXPECT_THROW(classify(view_of(values, {7, 1, 1}), IsoLevel{std::nan("")}), InvalidArgument);
}

/// Few whole numbers: voxels and saddles at the iso value are frequent. In every other volume, of
/// one cube, so are tunnels.
testing::SmallVolume with_ties(std::uint32_t seed) {
  std::mt19937 random(seed);
  const bool one_cube = seed % 2 == 0;
  testing::SmallVolume volume;
  volume.dims = one_cube ? Index3{2, 2, 2} : Index3{4, 3, 3};
  volume.values.resize(one_cube ? 8 : 36);
  for (double& value : volume.values) value = static_cast<double>(random() % 9) - 4;
  if (one_cube) {
    for (std::size_t n = 0; n < 8; ++n) {
      const bool at_end = n % 7 == 0;
      volume.values[n] = std::abs(volume.values[n]) + (at_end ? 3 : 0);
      if (at_end != (seed % 8 < 4)) volume.values[n] *= -1;
    }
  }
  return volume;
}

/// One thing that classify() decides, and its place in half voxels.
struct Decision {
  enum What { inside_vertex, joined_face, tunnel_of_outside, tunnel_of_inside };

  What what;
  Index3 place;
  auto operator<=>(const Decision&) const = default;
};

std::set<Decision> decisions(const VoxelSides& sides) {
  std::set<Decision> found;
  const auto add = [&](Decision::What what, std::uint32_t vertex, const Index3& half) {
    const auto p = sides.lattice.position(vertex);
    Decision decision{what, {}};
    for (int a = 0; a < 3; ++a) decision.place[a] = 2 * (sides.lattice.first[a] + p[a]) + half[a];
    found.insert(decision);
  };
  for (std::uint32_t v = 0; v < sides.lattice.vertex_count(); ++v) {
    if (sides.is_on(Side::inside, v)) add(Decision::inside_vertex, v, {0, 0, 0});
    for (int a = 0; a < 3; ++a) {
      Index3 half{1, 1, 1};
      half[a] = 0;
      if ((sides.cubes[v] >> a & VoxelSides::lower_face_joined) != 0)
        add(Decision::joined_face, v, half);
    }
  }
  for (const VoxelSides::Tunnel& tunnel : sides.tunnels)
    add(joined_side(sides, tunnel) == Side::inside ? Decision::tunnel_of_inside
                                                   : Decision::tunnel_of_outside,
        tunnel.cube, {1, 1, 1});
  return found;
}

TEST(VoxelSides, TiesAreDecidedAlikeUnderEverySymmetry) {
  constexpr IsoLevel zero{0.0, InsideRule::above};
  std::array<std::size_t, 4> seen{};  // by Decision::What
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    const testing::SmallVolume volume = with_ties(seed);
    const Boundary boundary = seed % 4 < 2 ? Boundary::closed : Boundary::open;
    const std::set<Decision> expected = decisions(classify(volume.view(), zero, boundary));
    for (const Decision& decision : expected) ++seen[decision.what];
    std::array<int, 3> permutation{0, 1, 2};
    do {
      for (unsigned flips = 0; flips < 8; ++flips) {
        const std::array<bool, 3> flip{(flips & 1U) != 0, (flips & 2U) != 0, (flips & 4U) != 0};
        std::set<Decision> turned;
        for (const Decision& decision : expected) {
          Index3 place{};
          for (int a = 0; a < 3; ++a) {
            const std::int64_t from = decision.place[permutation[a]];
            place[a] = flip[a] ? 2 * (volume.dims[permutation[a]] - 1) - from : from;
          }
          turned.insert({decision.what, place});
        }
        const testing::SmallVolume other = testing::transformed(volume, permutation, flip);
        ASSERT_EQ(decisions(classify(other.view(), zero, boundary)), turned) << "seed " << seed;
      }
    } while (std::next_permutation(permutation.begin(), permutation.end()));
  }
  for (const std::size_t count : seen) EXPECT_GT(count, 40U);
}

TEST(VoxelSides, OppositeValuesUnderTheOppositeRuleAreDecidedAlike) {
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    testing::SmallVolume volume = with_ties(seed);
    const VoxelSides above = classify(volume.view(), IsoLevel{0.0, InsideRule::above});
    for (double& value : volume.values) value = -value;
    const VoxelSides below = classify(volume.view(), IsoLevel{0.0, InsideRule::below});
    EXPECT_EQ(above.inside, below.inside);
    EXPECT_EQ(above.cubes, below.cubes);
    EXPECT_EQ(above.tunnels, below.tunnels);
  }
}

TEST(VoxelSides, TheOppositeRuleSwapsTheSidesWhereNothingIsTied) {
  std::size_t tunnels = 0;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const testing::SmallVolume volume = testing::white_noise({6, 6, 6}, seed);
    const auto decided = [&](InsideRule rule) {
      return classify(volume.view(), IsoLevel{0.0, rule}, Boundary::open);
    };
    const VoxelSides above = decided(InsideRule::above);
    const VoxelSides below = decided(InsideRule::below);
    ASSERT_EQ(above.lattice.dims, below.lattice.dims);
    ASSERT_EQ(above.tunnels.size(), below.tunnels.size());
    for (std::size_t t = 0; t < above.tunnels.size(); ++t) {
      EXPECT_EQ(above.tunnels[t].cube, below.tunnels[t].cube);
      EXPECT_NE(joined_side(above, above.tunnels[t]), joined_side(below, below.tunnels[t]));
    }
    tunnels += above.tunnels.size();
  }
  EXPECT_GT(tunnels, 50U);
}

}  // namespace
}  // namespace isoloop
