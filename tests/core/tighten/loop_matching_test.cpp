#include "core/tighten/loop_matching.h"

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

Z2Basis unit_vectors(std::uint32_t rank) {
  Z2Basis basis;
  for (std::uint32_t i = 0; i < rank; ++i) basis.add({&i, 1});
  return basis;
}

BasisMember member(GeneratorSet other, std::uint32_t loop = BasisMember::no_loop) {
  return {{}, 1.0, std::move(other), loop};
}

TEST(LoopMatching, GivesEveryMemberALoopAmongItsCoordinates) {
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    const std::uint32_t rank = 1 + random() % 12;
    Z2Basis basis;
    std::vector<BasisMember> members;
    while (members.size() < rank) {
      GeneratorSet set;
      for (std::uint32_t i = 0; i < rank; ++i)
        if (random() % 3 == 0) set.push_back(i);
      const bool is_loop = random() % 2 == 0;
      const auto loop = static_cast<std::uint32_t>(members.size());
      if (basis.add(set)) members.push_back(member(set, is_loop ? loop : BasisMember::no_loop));
    }
    const std::vector<std::uint32_t> loop_of = match_loops(members, unit_vectors(rank));
    EXPECT_EQ(std::set<std::uint32_t>(loop_of.begin(), loop_of.end()).size(), rank);
    for (std::uint32_t m = 0; m < rank; ++m)
      EXPECT_EQ(std::count(members[m].other.begin(), members[m].other.end(), loop_of[m]), 1);
  }
}

TEST(LoopMatching, KeepsLoopsAndGivesTheLastFreeOneToOthers) {
  const std::vector<BasisMember> members{member({0}, 0), member({0, 1, 3}), member({2}, 2),
                                         member({1})};
  EXPECT_EQ(match_loops(members, unit_vectors(4)), (std::vector<std::uint32_t>{0, 3, 2, 1}));
}

TEST(LoopMatching, ALoopMovesOnWhereAnotherNeedsItsNumber) {
  const std::vector<BasisMember> members{member({0, 1}, 0), member({0})};
  EXPECT_EQ(match_loops(members, unit_vectors(2)), (std::vector<std::uint32_t>{1, 0}));
}

TEST(LoopMatching, RefusesMembersThatDepend) {
  const std::vector<BasisMember> members{member({0}), member({0})};
  EXPECT_THROW(match_loops(members, unit_vectors(2)), SelfCheckFailed);
}

}  // namespace
}  // namespace isoloop
