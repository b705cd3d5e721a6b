#include "core/base/disjoint_sets.h"

#include <algorithm>
#include <atomic>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "core/base/threads.h"

namespace isoloop {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs random_pairs(std::uint32_t count, std::size_t pairs, std::uint32_t seed) {
  std::mt19937 random(seed);
  Pairs result(pairs);
  for (auto& [a, b] : result) a = random() % count, b = random() % count;
  return result;
}

std::vector<std::uint32_t> roots_after(std::uint32_t count, const Pairs& unions) {
  DisjointSets sets(count);
  for (const auto& [a, b] : unions) sets.unite(a, b);
  std::vector<std::uint32_t> roots(count);
  for (std::uint32_t member = 0; member < count; ++member) roots[member] = sets.find(member);
  return roots;
}

TEST(DisjointSets, StartWithEveryMemberAlone) {
  EXPECT_EQ(roots_after(4, {}), (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(DisjointSets, UniteSaysWhetherTwoSetsBecameOne) {
  DisjointSets sets(4);
  EXPECT_TRUE(sets.unite(3, 1));
  EXPECT_TRUE(sets.unite(1, 2));
  EXPECT_FALSE(sets.unite(2, 3));
  EXPECT_FALSE(sets.unite(0, 0));
  EXPECT_TRUE(sets.unite(0, 3));
}

TEST(DisjointSets, RootIsTheLeastMemberWhateverTheOrderOfTheUnions) {
  constexpr std::uint32_t count = 300;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Pairs unions = random_pairs(count, 200, seed);
    // Spread the least number along the unions until nothing changes.
    std::vector<std::uint32_t> least(count);
    for (std::uint32_t member = 0; member < count; ++member) least[member] = member;
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [a, b] : unions) {
        const std::uint32_t both = std::min(least[a], least[b]);
        changed = changed || least[a] != both || least[b] != both;
        least[a] = least[b] = both;
      }
    }
    EXPECT_EQ(roots_after(count, unions), least);
    std::reverse(unions.begin(), unions.end());
    for (auto& [a, b] : unions) std::swap(a, b);
    EXPECT_EQ(roots_after(count, unions), least);
  }
}

TEST(DisjointSets, UnionsByManyThreadsComeToTheSameSets) {
  constexpr std::uint32_t count = 20'000;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Pairs unions = random_pairs(count, 18'000, seed);
    DisjointSets sets(count);
    std::atomic<std::uint32_t> joined = 0;
    with_threads(8, [&] {
      tbb::parallel_for(std::size_t{0}, unions.size(), [&](std::size_t i) {
        if (sets.unite_shared(unions[i].first, unions[i].second)) ++joined;
      });
    });
    const std::vector<std::uint32_t> expected = roots_after(count, unions);
    std::uint32_t roots = 0;
    for (std::uint32_t member = 0; member < count; ++member) {
      ASSERT_EQ(sets.find(member), expected[member]) << "seed " << seed;
      roots += expected[member] == member ? 1 : 0;
    }
    EXPECT_EQ(joined, count - roots);
  }
}

}  // namespace
}  // namespace isoloop
