#include "core/tighten/basis_exchange.h"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "tests/oracles/basis_comparison.h"

namespace isoloop {
namespace {

std::vector<BasisMember> members_of(const testing::WithLoops& loops) {
  std::vector<BasisMember> members;
  for (const Loop& loop : loops.tunnels) {
    const auto set = class_of(loops.prepared.surface, loops.classes, loop.curves);
    members.push_back({loop.curves, loop.length,
                       split_class(loops.classes, Side::outside, set).other,
                       static_cast<std::uint32_t>(members.size())});
  }
  return members;
}

TEST(BasisExchange, SearchesFromEveryVertexEndInTheLeastBasis) {
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const testing::WithLoops loops(testing::smooth_noise({9, 9, 9}, seed, 1));
    if (loops.tunnels.empty()) continue;
    const Surface& surface = loops.prepared.surface;
    BasisExchange exchange(surface, loops.classes, Side::outside, members_of(loops));
    const double longest = exchange.members().back().length;
    std::vector<SearchStart> starts;
    for (std::uint32_t v = 0; v < surface.points.size(); ++v)
      starts.push_back({v, {longest, 64}, {}});
    EXPECT_EQ(exchange.search(starts).size(), starts.size());
    double total = 0.0;
    for (const BasisMember& member : exchange.members()) total += member.length;
    EXPECT_NEAR(total, testing::least_length(loops, Side::outside), 1e-4);
    EXPECT_TRUE(std::is_sorted(
        exchange.members().begin(), exchange.members().end(),
        [](const BasisMember& a, const BasisMember& b) { return a.length < b.length; }));
  }
}

TEST(BasisExchange, KeepsItsMembersWhereNothingIsShorter) {
  const testing::WithLoops loops(testing::linked_tori({24, 24, 24}));
  BasisExchange exchange(loops.prepared.surface, loops.classes, Side::outside, members_of(loops));
  const std::vector<SearchStart> starts{{0, {1.0, 4}, {}}};
  EXPECT_GT(exchange.search(starts).front().settled, 0U);
  ASSERT_EQ(exchange.members().size(), 2U);
  for (const BasisMember& member : exchange.members()) EXPECT_NE(member.loop, BasisMember::no_loop);
}

}  // namespace
}  // namespace isoloop
