#include "core/complex/order.h"

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

/// Pieces that have a size and border on nothing.
struct LoosePieces {
  std::vector<std::uint32_t> numbers;  // ascending
  std::vector<float> sizes;            // by number

  std::uint32_t piece_bound() const { return static_cast<std::uint32_t>(sizes.size()); }
  std::uint32_t cell_bound() const { return 0; }
  std::uint32_t edge_bound() const { return 0; }
  std::vector<std::uint32_t> pieces() const { return numbers; }
  std::vector<std::uint32_t> edges() const { return {}; }
  std::uint32_t layer_count() const { return 1; }
  std::uint32_t first_cell(std::uint32_t) const { return 0; }
  template <class Visit>
  void for_each_piece(std::uint32_t, const Visit& visit) const {
    for (const std::uint32_t piece : numbers) visit(piece);
  }
  template <class Visit>
  void for_each_edge(std::uint32_t, const Visit&) const {}
  float size(std::uint32_t piece) const { return sizes[piece]; }
  std::array<std::uint32_t, 2> cells(std::uint32_t) const { return {0, 0}; }
  ShortList<std::uint32_t, 4> edges_of(std::uint32_t) const { return {}; }
  ShortList<std::uint32_t, 4> ring(std::uint32_t) const { return {}; }
};
static_assert(Complex<LoosePieces>);

TEST(Order, LargestSizeComesFirstAndInfinityBeforeAll) {
  const float infinity = std::numeric_limits<float>::infinity();
  const LoosePieces complex{{0, 1, 2, 3, 4}, {1.5F, infinity, 0.0F, 1e-30F, 2.0F}};
  EXPECT_EQ(pieces_from_largest(complex), (std::vector<std::uint32_t>{1, 4, 0, 3, 2}));
}

TEST(Order, LargestNumberComesFirstAmongEqualSizes) {
  const LoosePieces complex{{0, 1, 2, 3}, {1.0F, 2.0F, 1.0F, 1.0F}};
  EXPECT_EQ(pieces_from_largest(complex), (std::vector<std::uint32_t>{1, 3, 2, 0}));
}

TEST(Order, KeepsToTheNumbersInUse) {
  const LoosePieces complex{{1, 3}, {9.0F, 1.0F, 9.0F, 2.0F}};
  EXPECT_EQ(pieces_from_largest(complex), (std::vector<std::uint32_t>{3, 1}));
}

TEST(Order, IsThatOfAComparisonOfSizeThenNumber) {
  std::mt19937 random(1);
  LoosePieces complex;
  for (std::uint32_t piece = 0; piece < 100'000; ++piece) {
    complex.numbers.push_back(piece);
    complex.sizes.push_back(0.25F * static_cast<float>(random() % 1000));
  }
  std::vector<std::uint32_t> expected = complex.numbers;
  std::sort(expected.begin(), expected.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(complex.sizes[a], a) > std::pair(complex.sizes[b], b);
  });
  EXPECT_EQ(pieces_from_largest(complex), expected);
}

TEST(Order, TheLargestMissingAreTheHeadOfAllMissing) {
  std::mt19937 random(2);
  LoosePieces complex;
  for (std::uint32_t piece = 0; piece < 5'000'000; ++piece)
    complex.sizes.push_back(static_cast<float>(random()) * 1e-3F);
  BitSet known(complex.piece_bound());
  for (std::uint32_t piece = 0; piece < complex.piece_bound(); ++piece)
    if (random() % 10 == 0)
      known.insert(piece);
    else
      complex.numbers.push_back(piece);
  const std::vector<std::uint32_t> all = pieces_from_largest(complex);
  const std::vector<std::uint32_t> head = largest_missing(complex, known);
  EXPECT_GE(head.size(), all.size() / 8);
  EXPECT_LE(head.size(), all.size() / 4);
  EXPECT_TRUE(std::equal(head.begin(), head.end(), all.begin()));
}

TEST(Order, AFewMissingComeAllAtOnce) {
  const LoosePieces complex{{0, 1, 2, 3}, {1.0F, 2.0F, 0.0F, 3.0F}};
  BitSet known(4);
  known.insert(1);
  EXPECT_EQ(largest_missing(complex, known), (std::vector<std::uint32_t>{3, 0, 2}));
  for (std::uint32_t piece = 0; piece < 4; ++piece) known.insert(piece);
  EXPECT_TRUE(largest_missing(complex, known).empty());
}

}  // namespace
}  // namespace isoloop
