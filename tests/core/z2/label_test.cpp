#include "core/z2/label.h"

#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

TEST(LabelPool, SumsAreSymmetricDifferences) {
  std::mt19937 random(1);
  LabelPool pool;
  std::vector<GeneratorSet> sets;
  std::vector<std::uint32_t> labels;
  for (int i = 0; i < 200; ++i) {
    std::set<std::uint32_t> set;
    for (unsigned k = random() % 6; k > 0; --k) set.insert(random() % 12);
    sets.emplace_back(set.begin(), set.end());
    labels.push_back(pool.intern(sets.back()));
  }
  for (std::size_t a = 0; a < sets.size(); ++a)
    for (std::size_t b = 0; b < sets.size(); ++b) {
      const std::uint32_t sum = pool.sum(labels[a], labels[b]);
      const auto members = pool.generators(sum);
      EXPECT_EQ(GeneratorSet(members.begin(), members.end()), sum_of(sets[a], sets[b]));
      EXPECT_EQ(sum == 0, sets[a] == sets[b]);
    }
}

TEST(LabelPool, EqualSetsHaveEqualNumbers) {
  LabelPool pool;
  const GeneratorSet set{1, 5, 9};
  EXPECT_EQ(pool.intern(set), pool.intern(set));
  EXPECT_EQ(pool.intern({}), 0U);
  EXPECT_EQ(pool.count(), 2U);
}

TEST(SparseLabels, KeepWhatWasSetAndVisitItInOrder) {
  SparseLabels labels(10'000);
  labels.set(9'999, 3);
  labels.set(17, 2);
  labels.set(18, 0);
  EXPECT_EQ(labels[17], 2U);
  EXPECT_EQ(labels[16], 0U);
  std::vector<std::uint32_t> pieces;
  labels.for_each([&](std::uint32_t piece, std::uint32_t) { pieces.push_back(piece); });
  EXPECT_EQ(pieces, (std::vector<std::uint32_t>{17, 9'999}));
  const std::vector<std::uint32_t> map{0, 0, 7, 0};
  labels.relabel(map);
  EXPECT_EQ(labels[17], 7U);
  EXPECT_EQ(labels[9'999], 0U);
}

}  // namespace
}  // namespace isoloop
