#include "core/engines/dual_pass.h"

#include <array>
#include <atomic>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "core/engines/pair.h"
#include "tests/oracles/explicit_complex.h"
#include "tests/oracles/pair_comparison.h"
#include "tests/oracles/slow_killing.h"
#include "tests/samples/core_fixture.h"
#include "tests/samples/random_sizes.h"

namespace isoloop {
namespace {

using testing::Prepared;
using testing::SmallVolume;

/// Compares the killing pieces with those of the slow reduction, and says what differs if anything
/// does. Adds their number to `compared`.
std::string compare_with_oracle(const SmallVolume& volume, std::atomic<std::size_t>& compared) {
  const Prepared prepared(volume);
  if (prepared.surface.points.empty()) return "";
  const oracle::ExplicitComplex slow = oracle::build_complex(
      volume.values, volume.dims, prepared.sides.lattice, testing::walls_of(prepared.sides));
  for (const Side side : {Side::inside, Side::outside}) {
    const GridComplex& complex = prepared.complex(side);
    const std::vector<testing::SidedPiece> expected =
        testing::slow_killing_pieces(prepared, slow, {&side, 1});
    const DualPass pass = prepared.pass_on(side);
    std::vector<testing::SidedPiece> found;
    for (const KillingPiece& killing : pass.killing) found.push_back({side, killing.piece});
    if (found != expected)
      return "the killing pieces differ: " + std::to_string(found.size()) + " and " +
             std::to_string(expected.size());
    if (static_cast<std::int64_t>(found.size()) != prepared.surface.genus())
      return "their number is not the genus";
    if (!labels_are_consistent(complex, pass)) return "the labels are no cocycle";
    const testing::WrittenSide written = testing::written_side(prepared, slow, side);
    std::vector<testing::SidedPiece> found_written;
    for (const KillingPiece& killing : dual_pass(written.complex, written.sizes).killing)
      found_written.push_back(written.pieces[killing.piece]);
    if (found_written != expected) return "those of the complex that is written out differ";
    compared += found.size();
  }
  return "";
}

/// `least`: killing pieces that must have come up, lest the comparison be empty.
void expect_equal_on(int count, std::size_t least,
                     const std::function<SmallVolume(std::uint32_t)>& make) {
  std::atomic<std::size_t> compared = 0;
  tbb::parallel_for(0, count, [&](int i) {
    const std::string complaint =
        compare_with_oracle(make(static_cast<std::uint32_t>(i)), compared);
    EXPECT_EQ(complaint, "") << "volume " << i;
  });
  EXPECT_GE(compared, least);
}

Index3 random_dims(std::uint32_t seed, std::int64_t least, std::int64_t most) {
  const std::int64_t span = most - least + 1;
  return {least + seed % span, least + seed / 7 % span, least + seed / 31 % span};
}

TEST(DualPass, FindsTheKillingPiecesOfTheSlowReductionOnWhiteNoise) {
  expect_equal_on(1200, 3'500,
                  [](std::uint32_t i) { return testing::white_noise(random_dims(i, 2, 6), i); });
}

TEST(DualPass, FindsTheKillingPiecesOfTheSlowReductionOnSmoothNoise) {
  expect_equal_on(900, 1'500, [](std::uint32_t i) {
    return testing::smooth_noise(random_dims(i, 4, 9), i, 1 + static_cast<int>(i % 2));
  });
}

TEST(DualPass, FindsTheKillingPiecesOfTheSlowReductionOnTwelveCubed) {
  expect_equal_on(24, 400, [](std::uint32_t i) {
    return testing::smooth_noise({12, 12, 12}, i, 1);
  });
}

TEST(DualPass, FindsTheKillingPiecesOfTheSlowReductionOnShapes) {
  const std::vector<SmallVolume> shapes{testing::torus({12, 12, 12}), testing::torus({12, 11, 9}),
                                        testing::torus_shell({12, 12, 12}),
                                        testing::linked_tori({12, 12, 12})};
  expect_equal_on(static_cast<int>(shapes.size()), 12, [&](std::uint32_t i) { return shapes[i]; });
}

TEST(DualPass, AgreesWhenManySizesAreEqual) {
  expect_equal_on(600, 60, [](std::uint32_t i) {
    return testing::from_bits({3, 3, 3}, i * 2654435761U >> 3);
  });
}

TEST(DualPass, FindsTheKillingPiecesUnderAnyOrder) {
  // Sizes along M leave few generators for relations to eliminate; random ones leave many.
  std::size_t compared = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const Prepared prepared(seed % 2 == 0 ? testing::white_noise({6, 7, 5}, seed)
                                          : testing::smooth_noise({9, 8, 9}, seed, 1));
    if (prepared.surface.points.empty()) continue;
    std::mt19937 random(seed);
    std::array<FlatSizes, 2> sizes;  // by side
    for (const Side side : {Side::inside, Side::outside})
      sizes[static_cast<std::size_t>(side)] =
          testing::random_sizes(prepared.complex(side), 1000, random);
    const FlatSizes& outside = sizes[static_cast<std::size_t>(Side::outside)];
    const FlatSizes& inside = sizes[static_cast<std::size_t>(Side::inside)];
    const std::vector<SurfacePair> pairs =
        pair_simplices(prepared.surface, SizedSide{*prepared.inside, inside},
                       SizedSide{*prepared.outside, outside});
    for (const Side side : {Side::inside, Side::outside}) {
      const DualPass pass =
          dual_pass(prepared.complex(side), sizes[static_cast<std::size_t>(side)]);
      EXPECT_EQ(testing::killing_pieces(pass), testing::killing_pieces(pairs, side)) << seed;
      EXPECT_TRUE(labels_are_consistent(prepared.complex(side), pass));
      compared += pass.killing.size();
    }
  }
  EXPECT_GT(compared, 400U);
}

TEST(DualPass, PiecesOfALabelAreNoLargerThanItsKillingPiece) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Prepared prepared(testing::smooth_noise({14, 14, 14}, seed, 1));
    for (const Side side : {Side::inside, Side::outside}) {
      const GridSizes sizes = prepared.sizes_on(side);
      const DualPass pass = prepared.pass_on(side);
      pass.labels.for_each([&](std::uint32_t piece, std::uint32_t label) {
        for (const std::uint32_t generator : pass.pool.generators(label))
          ASSERT_LE(std::pair(sizes.of_piece(piece), piece),
                    std::pair(pass.killing[generator].size, pass.killing[generator].piece));
      });
    }
  }
}

TEST(DualPass, InconsistentLabelsAreNoticed) {
  const Prepared prepared(testing::torus({16, 16, 16}));
  const GridComplex& complex = prepared.complex(Side::inside);
  DualPass pass = prepared.pass_on(Side::inside);
  ASSERT_TRUE(labels_are_consistent(complex, pass));
  const std::uint32_t piece = pass.killing.front().piece;
  const std::uint32_t own = pass.labels[piece];
  pass.labels.set(piece, 0);
  EXPECT_FALSE(labels_are_consistent(complex, pass));
  pass.labels.set(piece, own);
  ASSERT_TRUE(labels_are_consistent(complex, pass));
}

}  // namespace
}  // namespace isoloop
