#include "core/octree/ranked_bits.h"

#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

TEST(RankedBits, CountWhatComesBefore) {
  std::mt19937_64 random(1);
  for (int words = 0; words < 5; ++words) {
    std::vector<std::uint64_t> members(static_cast<std::size_t>(words));
    for (std::uint64_t& word : members) {
      word = random();
      word &= random();
    }
    const RankedBits bits(members);
    const auto bound = static_cast<std::uint32_t>(64 * words);
    std::uint32_t before = 0;
    for (std::uint32_t number = 0; number < bound; ++number) {
      EXPECT_EQ(bits.rank(number), before);
      const bool is_member = (members[number / 64] >> (number % 64) & 1U) != 0;
      EXPECT_EQ(bits[number], is_member);
      before += is_member ? 1 : 0;
      for (std::uint32_t i = 0; i < 64; ++i)
        EXPECT_EQ((bits.bits(number) >> i & 1U) != 0, number + i < bound && bits[number + i]);
    }
    EXPECT_EQ(bits.rank(bound), before);
    EXPECT_EQ(bits.count(), before);
    std::uint32_t met = 0;
    for (std::size_t w = 0; w < bits.word_count(); ++w)
      bits.visit_word(w, [&](std::uint32_t rank, std::uint32_t number) {
        EXPECT_EQ(rank, met++);
        EXPECT_EQ(bits.rank(number), rank);
        EXPECT_TRUE(bits[number]);
      });
    EXPECT_EQ(met, before);
  }
}

}  // namespace
}  // namespace isoloop
