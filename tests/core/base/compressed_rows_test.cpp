#include "core/base/compressed_rows.h"

#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "core/base/threads.h"

namespace isoloop {
namespace {

TEST(CompressedRows, HoldEachValueOnceInItsRowAscendingWhateverTheThreads) {
  constexpr std::uint32_t rows = 40;
  constexpr std::uint32_t values = 50'000;
  const auto row_of = [](std::uint32_t i) { return i * i % 39; };  // none in the last
  const auto value_of = [](std::uint32_t i) { return i * 7 % 1000; };
  std::vector<std::set<std::uint32_t>> expected(rows);
  for (std::uint32_t i = 0; i < values; ++i) expected[row_of(i)].insert(value_of(i));
  RowCollector collector(rows);
  const CompressedRows found = with_threads(8, [&] {
    tbb::parallel_for(0U, values, [&](std::uint32_t i) { collector.count(row_of(i)); });
    collector.end_of_counting();
    tbb::parallel_for(0U, values, [&](std::uint32_t i) { collector.add(row_of(i), value_of(i)); });
    return collector.take();
  });
  ASSERT_EQ(found.first.size(), rows + 1);
  EXPECT_EQ(found.first.back(), found.values.size());
  for (std::uint32_t row = 0; row < rows; ++row) {
    const std::vector<std::uint32_t> in_row(found.values.begin() + found.first[row],
                                            found.values.begin() + found.first[row + 1]);
    EXPECT_EQ(in_row, std::vector<std::uint32_t>(expected[row].begin(), expected[row].end()));
  }
}

}  // namespace
}  // namespace isoloop
