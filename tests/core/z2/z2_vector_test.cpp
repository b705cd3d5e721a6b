#include "core/z2/z2_vector.h"

#include <iterator>
#include <optional>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

using Ones = std::set<std::uint32_t>;

GeneratorSet listed(const Ones& ones) { return {ones.begin(), ones.end()}; }

std::optional<std::uint32_t> greatest_below(const Ones& ones, std::uint64_t bound) {
  for (auto at = ones.rbegin(); at != ones.rend(); ++at)
    if (*at < bound) return *at;
  return std::nullopt;
}

// Few of many elements stay a list, most of few become bits; sums of all kinds are met.
TEST(Z2Vector, SumsAndGreatestElementsAreThoseOfSets) {
  std::mt19937 random(7);
  for (int round = 0; round < 400; ++round) {
    Ones ones;
    Z2Vector vector;
    for (int term = 0; term < 12; ++term) {
      const std::uint32_t bound = random() % 3 == 0 ? 4'000'000'000U : 1 + random() % 300;
      Ones added;
      for (unsigned k = random() % 60; k > 0; --k) added.insert(random() % bound);
      vector.add(Z2Vector(listed(added)));
      for (const std::uint32_t element : added)
        if (!ones.insert(element).second) ones.erase(element);
      ASSERT_EQ(vector.ones(), listed(ones));
      ASSERT_EQ(vector.greatest(), greatest_below(ones, std::uint64_t{1} << 32));
      for (const std::uint64_t below : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{64},
                                        std::uint64_t{random() % 300}, std::uint64_t{random()}})
        ASSERT_EQ(vector.greatest_below(below), greatest_below(ones, below)) << below;
      if (random() % 4 == 0) {
        vector.add(vector);
        ones.clear();
        ASSERT_EQ(vector.greatest(), std::nullopt);
      }
    }
  }
}

}  // namespace
}  // namespace isoloop
