#include "core/complex/order.h"

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

struct FlatSizes {
  std::vector<float> by_piece;
  float of_piece(std::uint32_t piece) const { return by_piece[piece]; }
};

TEST(Order, LargestSizeComesFirstAndInfinityBeforeAll) {
  const float infinity = std::numeric_limits<float>::infinity();
  const FlatSizes sizes{{1.5F, infinity, 0.0F, 1e-30F, 2.0F}};
  EXPECT_EQ(from_largest(sizes, {0, 1, 2, 3, 4}), (std::vector<std::uint32_t>{1, 4, 0, 3, 2}));
}

TEST(Order, LargestNumberComesFirstAmongEqualSizes) {
  const FlatSizes sizes{{1.0F, 2.0F, 1.0F, 1.0F}};
  EXPECT_EQ(from_largest(sizes, {0, 1, 2, 3}), (std::vector<std::uint32_t>{1, 3, 2, 0}));
}

TEST(Order, IsThatOfAComparisonOfSizeThenNumber) {
  std::mt19937 random(1);
  FlatSizes sizes;
  std::vector<std::uint32_t> pieces;
  for (std::uint32_t piece = 0; piece < 100'000; ++piece) {
    pieces.push_back(piece);
    sizes.by_piece.push_back(0.25F * static_cast<float>(random() % 1000));
  }
  std::vector<std::uint32_t> expected = pieces;
  std::sort(expected.begin(), expected.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(sizes.of_piece(a), a) > std::pair(sizes.of_piece(b), b);
  });
  EXPECT_EQ(from_largest(sizes, pieces), expected);
}

TEST(Order, TheLargestMissingAreTheHeadOfAllMissing) {
  std::mt19937 random(2);
  constexpr std::uint32_t bound = 5'000'000;
  FlatSizes sizes;
  for (std::uint32_t piece = 0; piece < bound; ++piece)
    sizes.by_piece.push_back(static_cast<float>(random()) * 1e-3F);
  BitSet known(bound);
  std::vector<std::uint32_t> missing;
  for (std::uint32_t piece = 0; piece < bound; ++piece)
    if (random() % 10 == 0)
      known.insert(piece);
    else
      missing.push_back(piece);
  const std::vector<std::uint32_t> all = from_largest(sizes, missing);
  const std::vector<std::uint32_t> head = largest_missing(sizes, bound, known);
  EXPECT_GE(head.size(), all.size() / 8);
  EXPECT_LE(head.size(), all.size() / 4);
  EXPECT_TRUE(std::equal(head.begin(), head.end(), all.begin()));
}

TEST(Order, AFewMissingComeAllAtOnce) {
  const FlatSizes sizes{{1.0F, 2.0F, 0.0F, 3.0F}};
  BitSet known(4);
  known.insert(1);
  EXPECT_EQ(largest_missing(sizes, 4, known), (std::vector<std::uint32_t>{3, 0, 2}));
  for (std::uint32_t piece = 0; piece < 4; ++piece) known.insert(piece);
  EXPECT_TRUE(largest_missing(sizes, 4, known).empty());
}

}  // namespace
}  // namespace isoloop
