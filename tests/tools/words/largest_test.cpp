#include "tools/words/largest.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

using Item = std::pair<int, char>;

const std::vector<Item> items{{2, 'a'}, {5, 'b'}, {2, 'c'}, {9, 'd'}};

TEST(Largest, ComeFirstAndOfEqualOnesTheFirst) {
  EXPECT_EQ(largest_first(items, &Item::first), (std::vector<std::size_t>{3, 1, 0, 2}));
}

TEST(Largest, AreTheRowsOfATableThatIsShort) {
  const auto letters = [](std::size_t most_rows) {
    std::string text;
    for (const Item* item : items_in_rows(items, most_rows, &Item::first)) text += item->second;
    return text;
  };
  EXPECT_EQ(letters(0), "abcd") << "all, in their order";
  EXPECT_EQ(letters(3), "dba");
  EXPECT_EQ(letters(9), "dbac");
}

}  // namespace
}  // namespace isoloop
