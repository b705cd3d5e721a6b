#include "core/cube/cube_interior.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "tests/oracles/cut_of_levels.h"
#include "tests/oracles/refined_cube.h"
#include "tests/oracles/swept_cube.h"

namespace isoloop {
namespace {

using testing::cut_of;
using testing::LevelCut;

TEST(CubeInterior, PartsAndCyclesAreThoseOfTheRefinedCube) {
  const testing::CubeComparison comparison = testing::compare_with_refined_cubes(20'000, 1);
  EXPECT_EQ(comparison.wrong, 0);
  EXPECT_GT(comparison.tunnels, 60);
  EXPECT_LT(comparison.unresolved, 20);
}

TEST(CubeInterior, HubsAreThoseOfTheCutsThatHaveTunnels) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::set<std::tuple<unsigned, unsigned, int>> expected;
  std::vector<unsigned> roomy;
  for (unsigned inside = 0; inside < 256; ++inside) {
    bool room = false;
    for (unsigned joined = 0; joined < 64; ++joined)
      for (const int hub :
           cube_cut(static_cast<std::uint8_t>(inside), static_cast<std::uint8_t>(joined), false)
               .hubs)
        room = room || hub >= 0;
    if (room) roomy.push_back(inside);
  }
  std::set<std::tuple<unsigned, unsigned, int>> drawn;
  std::set<std::tuple<unsigned, unsigned, int>> with_room;
  const auto draw = [&](unsigned inside) {
    CornerLevels levels{};
    for (unsigned c = 0; c < 8; ++c)
      levels[c] = std::exp(1.5 * normal(random)) * ((inside >> c & 1U) != 0 ? 1 : -1);
    const LevelCut cut = cut_of(levels);
    for (const int hub : cut.plain->hubs)
      with_room.emplace(cut.inside, cut.joined, static_cast<int>(cut.inside >> hub & 1U));
    const oracle::SweptCube swept = oracle::sweep(levels);
    for (const int side : {0, 1})
      if (swept.cycles[static_cast<std::size_t>(1 - side)] > 0)
        drawn.emplace(cut.inside, cut.joined, side);
    EXPECT_EQ(cut.hub.has_value(), swept.cycles[0] + swept.cycles[1] > 0);
  };
  for (int i = 0; i < 100'000; ++i) draw(random() % 256);
  for (int i = 0; i < 200'000; ++i) draw(roomy[random() % roomy.size()]);
  for (int i = 0; i < 200'000; ++i) draw(random() % 2 == 0 ? 0x69 : 0x96);
  EXPECT_EQ(drawn, with_room);
  EXPECT_EQ(drawn.size(), 148U);
}

std::optional<Side> joined_side(const CornerLevels& levels) {
  const LevelCut cut = cut_of(levels);
  if (!cut.hub) return std::nullopt;
  return (cut.inside >> *cut.hub & 1U) != 0 ? Side::inside : Side::outside;
}

TEST(CubeInterior, KnowsNoAxisAndNoDirection) {
  std::mt19937 random(5);
  int tunnels = 0;
  for (int i = 0; i < 20'000; ++i) {
    CornerLevels levels{};
    // Few small whole numbers: saddles at the iso value are frequent.
    for (double& level : levels) level = static_cast<double>(random() % 9) - 5;
    if (i % 2 == 0)
      for (unsigned c = 0; c < 8; ++c)
        levels[c] = std::abs(levels[c]) * (c == 0 || c == 7 ? 1 : -1);
    const std::optional<Side> expected = joined_side(levels);
    tunnels += expected ? 1 : 0;
    std::array<unsigned, 3> permutation{0, 1, 2};
    do {
      for (unsigned flips = 0; flips < 8; ++flips) {
        CornerLevels turned{};
        for (unsigned c = 0; c < 8; ++c) {
          unsigned to = 0;
          for (unsigned a = 0; a < 3; ++a) to |= (c >> a & 1U) << permutation[a];
          turned[to ^ flips] = levels[c];
        }
        ASSERT_EQ(joined_side(turned), expected);
      }
    } while (std::next_permutation(permutation.begin(), permutation.end()));
  }
  EXPECT_GT(tunnels, 100);
}

/// `ends` at two opposite corners, `rest` at the others.
CornerLevels along_diagonal(double ends, double rest) {
  return {ends, rest, rest, rest, rest, rest, rest, ends};
}

TEST(CubeInterior, ASaddleAtTheIsoValueIsOutside) {
  // The mean of the corners, the value at the saddle in the middle, is 0.
  EXPECT_FALSE(interior_tunnel(along_diagonal(3, -1)));
  EXPECT_EQ(interior_tunnel(along_diagonal(std::nextafter(3, 4), -1)), Side::inside);
  EXPECT_EQ(interior_tunnel(along_diagonal(-3, 1)), Side::outside);
  EXPECT_FALSE(interior_tunnel(along_diagonal(-std::nextafter(3, 2), 1)));
}

TEST(CubeInterior, ATieOnAFaceDoesNotHideATunnel) {
  // The corners 0 and 3 are kept apart by a tie on their face and may be joined behind it.
  std::mt19937 random(7);
  int tunnels = 0;
  for (int i = 0; i < 20'000; ++i) {
    CornerLevels levels{2, -2, -2, 2};
    for (unsigned c = 4; c < 8; ++c) levels[c] = 8.0 * random() / 4294967295.0 - 4.0;
    const oracle::SweptCube swept = oracle::sweep(levels);
    const LevelCut cut = cut_of(levels);
    ASSERT_EQ(cut.hub.has_value(), swept.cycles[0] + swept.cycles[1] > 0);
    tunnels += cut.hub ? 1 : 0;
  }
  EXPECT_GT(tunnels, 100);
}

TEST(CubeInterior, CornersAtTheIsoValueAreInside) {
  // All cubes of four levels, 0 among them, beside the cube followed from slice to slice.
  constexpr std::array<double, 4> values{-3, -1, 0, 2};
  int tunnels = 0;
  for (unsigned n = 0; n < 65536; ++n) {
    CornerLevels levels{};
    for (unsigned c = 0; c < 8; ++c) levels[c] = values[n >> (2 * c) & 3U];
    const LevelCut cut = cut_of(levels);
    if (cube_cut(cut.inside, cut.joined, false).hubs.count == 0) continue;
    const oracle::SweptCube swept = oracle::sweep(levels);
    ASSERT_EQ(cut.hub.has_value(), swept.cycles[0] + swept.cycles[1] > 0) << n;
    if (!cut.hub) continue;
    ++tunnels;
    for (const Vec3& point : tunnel_ring(levels, *cut.hub, 1e-3))
      for (const double share : point) ASSERT_TRUE(share >= 1e-3 && share <= 1 - 1e-3) << n;
  }
  EXPECT_GT(tunnels, 100);
  // Six corners at the iso value round a diagonal: below it the ends of the diagonal are joined.
  EXPECT_EQ(interior_tunnel(along_diagonal(-1, 0)), Side::outside);
}

TEST(CubeInterior, SignsAreExactAtAnyScale) {
  for (const int exponent : {490, -260, -990}) {
    const double scale = std::ldexp(1.0, exponent);
    EXPECT_FALSE(interior_tunnel(along_diagonal(3 * scale, -scale)));
    EXPECT_EQ(interior_tunnel(along_diagonal(std::nextafter(3, 4) * scale, -scale)), Side::inside);
    EXPECT_FALSE(interior_tunnel(along_diagonal(std::nextafter(3, 2) * scale, -scale)));
  }
  // A corner 400 orders of magnitude below the others.
  CornerLevels levels = along_diagonal(1e150, -1e149);
  levels[1] = -1e-250;
  EXPECT_EQ(interior_tunnel(levels), Side::inside);
}

TEST(CubeInterior, RingsLieOnTheInterpolantAndAreNotDegenerate) {
  std::mt19937 random(11);
  int rings = 0;
  for (int i = 0; i < 100'000; ++i) {
    CornerLevels levels{};
    double largest = 0.0;
    for (double& level : levels) {
      level = 2.0 * random() / 4294967295.0 - 1.0;
      largest = std::max(largest, std::abs(level));
    }
    const std::optional<int> hub = cut_of(levels).hub;
    if (!hub) continue;
    ++rings;
    for (const Vec3& point : tunnel_ring(levels, *hub, 1e-12)) {
      double value = 0.0;
      for (unsigned c = 0; c < 8; ++c) {
        double weight = 1.0;
        for (unsigned a = 0; a < 3; ++a) weight *= (c >> a & 1U) != 0 ? point[a] : 1 - point[a];
        value += weight * levels[c];
      }
      EXPECT_NEAR(value, 0.0, 1e-9 * largest);
    }
    const auto ring = tunnel_ring(levels, *hub, 1e-3);
    for (std::size_t a = 0; a < ring.size(); ++a)
      EXPECT_GT(distance(ring[a], ring[(a + 1) % ring.size()]), 1e-3);
  }
  EXPECT_GT(rings, 300);
}

}  // namespace
}  // namespace isoloop
