#include "core/z2/z2_basis.h"

#include <optional>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

// Few elements and few vectors, and as many of both as make the rows dense.
TEST(Z2Basis, CoordinatesSumToTheVector) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    const bool dense = round % 20 == 0;
    Z2Basis basis;
    std::vector<GeneratorSet> members;
    for (int i = 0; i < (dense ? 180 : 12); ++i) {
      std::set<std::uint32_t> set;
      for (unsigned k = 1 + random() % (dense ? 40 : 4); k > 0; --k)
        set.insert(random() % (dense ? 150 : 10));
      const GeneratorSet vector(set.begin(), set.end());
      const bool was_in_span = basis.coordinates(vector).has_value();
      EXPECT_EQ(basis.add(vector).has_value(), !was_in_span);
      if (!was_in_span) members.push_back(vector);
      ASSERT_EQ(basis.rank(), members.size());
      const auto coordinates = basis.coordinates(vector);
      ASSERT_TRUE(coordinates.has_value());
      GeneratorSet sum;
      for (const std::uint32_t k : *coordinates) sum = sum_of(sum, members[k]);
      EXPECT_EQ(sum, vector);
    }
  }
}

TEST(Z2Basis, ARemainderHoldsNoPivotAndIsThatOfAllThatDifferByTheSpan) {
  std::mt19937 random(5);
  const auto random_set = [&] {
    std::set<std::uint32_t> set;
    for (unsigned k = 1 + random() % 6; k > 0; --k) set.insert(random() % 20);
    return GeneratorSet(set.begin(), set.end());
  };
  for (int round = 0; round < 200; ++round) {
    Z2Basis basis;
    std::vector<GeneratorSet> members;
    for (int i = 0; i < 8; ++i) {
      members.push_back(random_set());
      const GeneratorSet rest = basis.remainder(members.back());
      const auto pivot = basis.add(members.back());
      ASSERT_EQ(pivot, rest.empty() ? std::nullopt : std::optional(rest.back()));
    }
    GeneratorSet vector = random_set();
    const GeneratorSet rest = basis.remainder(vector);
    for (const std::uint32_t element : rest) EXPECT_FALSE(basis.is_pivot(element));
    for (const GeneratorSet& member : members) vector = sum_of(vector, member);
    EXPECT_EQ(basis.remainder(vector), rest);
  }
}

TEST(Z2Basis, RefusesTheZeroVector) {
  Z2Basis basis;
  EXPECT_FALSE(basis.add({}));
  EXPECT_TRUE(basis.coordinates({})->empty());
}

}  // namespace
}  // namespace isoloop
