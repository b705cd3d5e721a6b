#include "core/surface/edge_set.h"

#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

/// `chance`: of a bit's being set, of 8.
EdgeSet random_set(std::uint32_t vertices, unsigned chance, unsigned seed) {
  return EdgeSet(vertices, [&](std::uint32_t b) {
    std::mt19937 random(seed + b);
    EdgeSet::BlockBits bits{};
    for (std::uint32_t i = 0; i < 64 && 64 * b + i < vertices; ++i)
      for (std::uint64_t& of_axis : bits) of_axis |= std::uint64_t{random() % 8 < chance} << i;
    return bits;
  });
}

TEST(EdgeSet, RanksNumberTheMembersInTheOrderOfBlocks) {
  for (const auto& [vertices, chance] :
       {std::pair{1U, 8U}, std::pair{64U, 3U}, std::pair{1000U, 8U}, std::pair{4097U, 1U},
        std::pair{700U, 0U}}) {
    const EdgeSet set = random_set(vertices, chance, 7);
    std::vector<bool> visited(3 * std::size_t{vertices});
    std::uint32_t next = 0;
    for (std::uint32_t b = 0; b < set.block_count(); ++b)
      set.visit_block(b, [&](std::uint32_t rank, std::uint32_t edge) {
        EXPECT_EQ(rank, next++);
        EXPECT_EQ(set.rank(edge), rank);
        EXPECT_EQ(edge / 3 / 64, b);
        visited[edge] = true;
      });
    EXPECT_EQ(next, set.count());
    for (std::uint32_t edge = 0; edge < 3 * vertices; ++edge) EXPECT_EQ(set[edge], visited[edge]);
  }
}

TEST(EdgeSet, TellsSixtyFourAtATimeFromAnyVertexOn) {
  constexpr std::uint32_t vertices = 200;
  const EdgeSet set = random_set(vertices, 4, 3);
  for (std::uint32_t axis = 0; axis < 3; ++axis)
    for (std::uint32_t first = 0; first < vertices; ++first) {
      const std::uint64_t bits = set.bits(axis, first);
      for (std::uint32_t i = 0; i < 64; ++i)
        EXPECT_EQ((bits >> i & 1U) != 0, first + i < vertices && set[3 * (first + i) + axis]);
    }
}

TEST(EdgeSet, TakesHalfAByteALatticeVertex) {
  EXPECT_EQ(random_set(64'000, 8, 1).bytes(), 32'000U);
}

}  // namespace
}  // namespace isoloop
