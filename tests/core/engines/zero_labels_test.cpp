#include "core/engines/zero_labels.h"

#include <gtest/gtest.h>

#include "core/engines/spanning_forest.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

/// Reads all rings again and again until nothing follows.
BitSet slow_zero_labels(const GridComplex& complex, const BitSet& forest) {
  BitSet known = forest;
  const std::vector<std::uint32_t> edges = all_edges(complex);
  for (bool any = true; any;) {
    any = false;
    for (const std::uint32_t edge : edges) {
      std::vector<std::uint32_t> unknown;
      for (const std::uint32_t piece : complex.ring(edge))
        if (!known[piece]) unknown.push_back(piece);
      if (unknown.size() != 1) continue;
      known.insert(unknown.front());
      any = true;
    }
  }
  return known;
}

TEST(ZeroLabels, AreThoseThatReadingRingByRingLeadsTo) {
  std::size_t open = 0;
  std::size_t closed = 0;
  for (std::uint32_t seed = 0; seed < 80; ++seed) {
    // Longer and shorter rows than a word, layers of part of a word, more slabs than one.
    const testing::Prepared p(seed % 4 == 0   ? testing::white_noise({71, 5, 6}, seed)
                              : seed % 4 == 1 ? testing::smooth_noise({130, 9, 11}, seed, 2)
                              : seed % 4 == 2 ? testing::smooth_noise({9, 10, 31}, seed, 1)
                                              : testing::white_noise({3, 70, 7}, seed));
    if (p.surface.points.empty()) continue;
    for (const Side side : {Side::inside, Side::outside}) {
      const GridComplex& complex = p.complex(side);
      const BitSet forest = largest_forest(complex, p.sizes_on(side));
      const BitSet known = zero_labels(complex, forest);
      const BitSet expected = slow_zero_labels(complex, forest);
      for (const std::uint32_t piece : all_pieces(complex)) {
        ASSERT_EQ(known[piece], expected[piece]) << "seed " << seed << ", piece " << piece;
        if (!expected[piece])
          ++open;
        else if (!forest[piece])
          ++closed;
      }
    }
  }
  EXPECT_GT(open, 10'000U);
  EXPECT_GT(closed, 10'000U);
}

TEST(ZeroLabels, NumbersThatAreNoPieceAreKnown) {
  const testing::Prepared p(testing::smooth_noise({12, 9, 10}, 3, 1));
  for (const Side side : {Side::inside, Side::outside}) {
    const GridComplex& complex = p.complex(side);
    const BitSet known = zero_labels(complex, largest_forest(complex, p.sizes_on(side)));
    std::vector<bool> is_piece(complex.piece_bound());
    for (const std::uint32_t piece : all_pieces(complex)) is_piece[piece] = true;
    known.for_each_missing(0, complex.piece_bound(),
                           [&](std::uint32_t number) { EXPECT_TRUE(is_piece[number]) << number; });
  }
}

}  // namespace
}  // namespace isoloop
