#include "core/base/potentials.h"

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

using Xor = Potentials<std::uint32_t, std::bit_xor<>>;

TEST(Potentials, WaysThatAgreeWithValuesOfTheMembersCloseWithZero) {
  std::mt19937 random(1);
  Xor potentials;
  std::vector<std::uint32_t> value;
  for (int i = 0; i < 400; ++i) {
    potentials.add();
    value.push_back(static_cast<std::uint32_t>(random()));
  }
  for (int i = 0; i < 600; ++i) {
    const auto a = static_cast<std::uint32_t>(random() % 400);
    const auto b = static_cast<std::uint32_t>(random() % 400);
    EXPECT_EQ(potentials.join(a, b, value[a] ^ value[b]), 0U);
  }
  for (std::uint32_t member = 0; member < 400; ++member) {
    const Xor::Place place = potentials.find(member);
    EXPECT_LE(place.root, member);
    EXPECT_EQ(place.value, value[member] ^ value[place.root]);
  }
}

TEST(Potentials, AClosedWayTellsItsValueAndChangesNothing) {
  Xor potentials;
  for (int i = 0; i < 3; ++i) potentials.add();
  EXPECT_EQ(potentials.join(1, 2, 5), 0U);
  EXPECT_EQ(potentials.join(0, 2, 3), 0U);
  EXPECT_EQ(potentials.join(0, 1, 7), 7U ^ 5U ^ 3U);
  EXPECT_EQ(potentials.find(1).value, 5U ^ 3U);
}

}  // namespace
}  // namespace isoloop
