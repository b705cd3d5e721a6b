#include "core/scan/sized_sets.h"

#include <array>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

TEST(SizedSets, CountSetsOfAtLeastASize) {
  const std::array<std::int64_t, 2> sizes{2, 4};
  SizedSets sets(6, sizes);
  for (std::uint32_t v = 0; v < 5; ++v) sets.enter(v);
  sets.enter(5, 7);
  EXPECT_EQ(sets.all(), 6);
  EXPECT_EQ(sets.of_size(), (std::vector<std::int64_t>{1, 1}));
  sets.unite(0, 1);
  sets.unite(2, 3);
  EXPECT_EQ(sets.of_size(), (std::vector<std::int64_t>{3, 1}));
  sets.unite(3, 1);
  sets.unite(0, 2);  // one set already
  EXPECT_EQ(sets.all(), 3);
  EXPECT_EQ(sets.of_size(), (std::vector<std::int64_t>{2, 2}));
  EXPECT_EQ(sets.largest(), 7U);
}

}  // namespace
}  // namespace isoloop
