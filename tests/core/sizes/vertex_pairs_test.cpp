#include "core/sizes/vertex_pairs.h"

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

namespace isoloop {
namespace {

using Pair = std::array<std::uint32_t, 2>;

VertexPairs collected(std::uint32_t vertices, const std::vector<Pair>& from) {
  PairCollector collector(vertices);
  for (const auto& [a, b] : from) collector.count(a, b);
  collector.end_of_counting();
  for (const auto& [a, b] : from) collector.add(a, b);
  return collector.take();
}

std::vector<Pair> random_pairs(std::uint32_t vertices, std::size_t count) {
  std::mt19937 random(5);
  std::vector<Pair> pairs;
  while (pairs.size() < count) {
    const Pair pair{static_cast<std::uint32_t>(random() % vertices),
                    static_cast<std::uint32_t>(random() % vertices)};
    if (pair[0] != pair[1]) pairs.push_back(pair);
  }
  return pairs;
}

TEST(VertexPairs, AreDistinctAndGroupedByTheLesserVertex) {
  const VertexPairs pairs = collected(5, {{3, 1}, {1, 3}, {0, 4}, {1, 2}, {1, 3}, {4, 3}});
  EXPECT_EQ(pairs.source_count(), 5U);
  EXPECT_EQ(pairs.first, (std::vector<std::uint32_t>{0, 1, 3, 3, 4, 4}));
  EXPECT_EQ(pairs.partner, (UnsetVector<std::uint32_t>{4, 2, 3, 4}));
}

TEST(VertexPairs, AreNoneWhereNoneWereCollected) {
  const VertexPairs pairs = collected(3, {});
  EXPECT_EQ(pairs.first, std::vector<std::uint32_t>(4, 0));
  EXPECT_TRUE(pairs.partner.empty());
}

TEST(VertexPairs, AreThoseOfASetAndEachIsFoundFromEitherEnd) {
  const std::vector<Pair> from = random_pairs(200, 5'000);
  std::set<Pair> expected;
  for (const auto& [a, b] : from) expected.insert({std::min(a, b), std::max(a, b)});
  const VertexPairs pairs = collected(200, from);
  EXPECT_EQ(pairs.partner.size(), expected.size());
  std::uint32_t position = 0;
  for (const auto& [a, b] : expected) {
    EXPECT_EQ(pairs.partner[position], b);
    EXPECT_EQ(pairs.find(a, b), position);
    EXPECT_EQ(pairs.find(b, a), position);
    ++position;
  }
}

TEST(VertexPairs, DoNotDependOnThreadsOrOrder) {
  std::vector<Pair> from = random_pairs(50, 100'000);
  const VertexPairs expected = collected(50, from);
  std::reverse(from.begin(), from.end());
  for (auto& [a, b] : from) std::swap(a, b);
  PairCollector collector(50);
  tbb::parallel_for(std::size_t{0}, from.size(),
                    [&](std::size_t i) { collector.count(from[i][0], from[i][1]); });
  collector.end_of_counting();
  tbb::parallel_for(std::size_t{0}, from.size(),
                    [&](std::size_t i) { collector.add(from[i][0], from[i][1]); });
  const VertexPairs pairs = collector.take();
  EXPECT_EQ(pairs.first, expected.first);
  EXPECT_EQ(pairs.partner, expected.partner);
}

}  // namespace
}  // namespace isoloop
