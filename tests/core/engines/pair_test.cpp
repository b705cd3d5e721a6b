#include "core/engines/pair.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "core/surface/surface_order.h"
#include "tests/oracles/explicit_complex.h"
#include "tests/oracles/literal_pair.h"
#include "tests/oracles/pair_comparison.h"
#include "tests/samples/real_data.h"

namespace isoloop {
namespace {

using testing::pairs_of;
using testing::Prepared;
using testing::SmallVolume;

constexpr std::array all_refinements{Refinement::none, Refinement::first, Refinement::second,
                                     Refinement::both};

/// `least`: killing pieces that must have come up, lest the comparison be empty.
template <class Make>
void expect_engines_agree_on(int count, std::size_t least, const Make& make) {
  std::atomic<std::size_t> compared = 0;
  tbb::parallel_for(0, count, [&](int i) {
    const Prepared prepared(make(static_cast<std::uint32_t>(i)));
    EXPECT_EQ(testing::difference_of_engines(prepared, compared), "") << "volume " << i;
  });
  EXPECT_GE(compared, least);
}

TEST(Pair, FindsTheKillingPiecesOfTheDualPassOnWhiteNoise) {
  expect_engines_agree_on(800, 6000, [](std::uint32_t i) {
    return testing::white_noise({2 + i % 7, 2 + i / 7 % 7, 2 + i / 49 % 7}, i);
  });
}

TEST(Pair, FindsTheKillingPiecesOfTheDualPassOnSmoothNoise) {
  expect_engines_agree_on(700, 3000, [](std::uint32_t i) {
    return testing::smooth_noise({5 + i % 12, 5 + i / 12 % 12, 5 + i / 144}, i,
                                 1 + static_cast<int>(i % 3));
  });
}

TEST(Pair, FindsTheKillingPiecesOfTheDualPassOnShapes) {
  const std::vector<SmallVolume> shapes{
      testing::torus({16, 16, 16}), testing::torus({12, 11, 9}), testing::torus_shell({16, 16, 16}),
      testing::linked_tori({16, 16, 16}), testing::from_bits({3, 3, 1}, 0b111101111)};
  expect_engines_agree_on(static_cast<int>(shapes.size()), 14,
                          [&](std::uint32_t i) { return shapes[i]; });
}

struct RealVolume {
  const char* name;
  Index3 dims;
  double iso;
  std::int64_t genus;
};

class PairOnRealVolume : public ::testing::TestWithParam<RealVolume> {};

TEST_P(PairOnRealVolume, FindsTheKillingPiecesOfTheDualPass) {
  const auto& [name, dims, iso, genus] = GetParam();
  const std::string extents =
      std::to_string(dims[0]) + "x" + std::to_string(dims[1]) + "x" + std::to_string(dims[2]);
  const std::string file = std::string("volumes/") + name + "_" + extents + "_uint8.raw";
  ISOLOOP_NEEDS(file);
  SmallVolume volume{{}, dims};
  for (const std::uint8_t value : testing::bytes_of(file)) volume.values.push_back(value - iso);
  const Prepared prepared(volume, GeodesicMode::hierarchy);
  std::int64_t compared = 0;
  EXPECT_EQ(testing::difference_of_engines(prepared, compared), "");
  EXPECT_EQ(compared, 2 * genus);
}

INSTANTIATE_TEST_SUITE_P(Volumes, PairOnRealVolume,
                         ::testing::Values(RealVolume{"fuel", {64, 64, 64}, 15, 8},
                                           RealVolume{"nucleon", {41, 41, 41}, 140, 0},
                                           RealVolume{"silicium", {98, 34, 34}, 85, 31},
                                           RealVolume{"neghip", {64, 64, 64}, 55, 3},
                                           RealVolume{"hydrogen", {128, 128, 128}, 15, 1},
                                           RealVolume{"engine_half", {128, 128, 64}, 70, 20}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Pair, KillsTheCyclesThatTheAlgorithmToTheLetterKills) {
  std::size_t compared = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const Prepared prepared(seed % 2 == 0 ? testing::white_noise({4, 5, 4}, seed)
                                          : testing::smooth_noise({7, 6, 7}, seed, 1));
    for (const Refinement refinement : all_refinements) {
      const std::vector<SurfacePair> pairs = pairs_of(prepared, refinement);
      auto pair = pairs.begin();
      for (const Side side : {Side::inside, Side::outside})
        for (const auto& expected : testing::literal_pairs(prepared, side, refinement)) {
          ASSERT_NE(pair, pairs.end());
          ASSERT_EQ(pair->side, side);
          ASSERT_EQ(pair->piece, expected.piece);
          const std::set<std::array<std::uint32_t, 2>> cycle(pair->cycle.begin(),
                                                             pair->cycle.end());
          ASSERT_EQ(cycle, expected.cycle) << "volume " << seed;
          ASSERT_EQ(cycle.size(), pair->cycle.size());
          ++compared;
          ++pair;
        }
      ASSERT_EQ(pair, pairs.end());
    }
  }
  EXPECT_GE(compared, 500U);
}

TEST(Pair, PairsEachOfTheUnpairedEdgesOfTheSurfaceOnce) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Prepared prepared(testing::white_noise({7, 7, 7}, seed));
    const SurfaceOrder order = order_surface(prepared.surface);
    const std::set<std::array<std::uint32_t, 2>> unpaired(order.edges.begin() + order.tree,
                                                          order.edges.begin() + order.killed);
    for (const Refinement refinement : all_refinements) {
      std::set<std::array<std::uint32_t, 2>> paired;
      for (const SurfacePair& pair : pairs_of(prepared, refinement)) paired.insert(pair.edge);
      EXPECT_EQ(paired, unpaired);
    }
  }
}

TEST(Pair, FirstRefinementChangesTheCyclesAndNotThePairs) {
  const Prepared prepared(testing::smooth_noise({14, 14, 14}, 3, 1));
  const std::vector<SurfacePair> last = pairs_of(prepared, Refinement::second);
  const std::vector<SurfacePair> first = pairs_of(prepared, Refinement::both);
  ASSERT_EQ(first.size(), last.size());
  std::size_t changed = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].piece, last[i].piece);
    EXPECT_EQ(first[i].edge, last[i].edge);
    changed += first[i].cycle == last[i].cycle ? 0 : 1;
  }
  EXPECT_GT(changed, 0U);
}

TEST(Pair, WithoutTheSecondRefinementPiecesKillByNumber) {
  const Prepared prepared(testing::smooth_noise({14, 14, 14}, 3, 1));
  const std::vector<SurfacePair> by_size = pairs_of(prepared, Refinement::both);
  const std::vector<SurfacePair> by_number = pairs_of(prepared, Refinement::first);
  for (const Side side : {Side::inside, Side::outside}) {
    const std::vector<std::uint32_t> pieces = testing::killing_pieces(by_number, side);
    EXPECT_TRUE(std::is_sorted(pieces.begin(), pieces.end()));
    EXPECT_NE(pieces, testing::killing_pieces(by_size, side));
  }
}

TEST(Pair, CountsTheFanTrianglesOfEveryPiece) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Prepared prepared(testing::white_noise({5, 4, 6}, seed));
    const oracle::ExplicitComplex slow =
        oracle::build_complex(prepared.volume.values, prepared.volume.dims, prepared.sides.lattice,
                              testing::walls_of(prepared.sides));
    std::map<oracle::ExplicitComplex::Place, std::uint64_t> expected;
    for (const auto& face : slow.faces) expected[face.place] += face.boundary.size() - 2;
    EXPECT_EQ(fan_triangle_count(*prepared.inside),
              expected[oracle::ExplicitComplex::Place::inside]);
    EXPECT_EQ(fan_triangle_count(*prepared.outside),
              expected[oracle::ExplicitComplex::Place::outside]);
  }
}

}  // namespace
}  // namespace isoloop
