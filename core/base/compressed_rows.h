// Lists of numbers, gathered by many threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/unset_vector.h"

namespace isoloop {

/// Row r: values[first[r]] .. values[first[r+1]-1].
struct CompressedRows {
  std::vector<std::uint32_t> first;  // size: rows + 1
  UnsetVector<std::uint32_t> values;

  std::span<const std::uint32_t> operator[](std::uint32_t row) const {
    return {values.data() + first[row], first[row + 1] - first[row]};
  }
};

/// Collects values in two rounds over the same sequence: first count() each, then add() each. Both
/// may be called from many threads at once; the result does not depend on their order.
class RowCollector {
 public:
  explicit RowCollector(std::uint32_t rows);
  void count(std::uint32_t row);
  void end_of_counting();
  void add(std::uint32_t row, std::uint32_t value);
  CompressedRows take();  // sorts each row and drops repetitions; the collector is spent

 private:
  std::vector<std::uint32_t> first_;   // while counting: at row + 1, the values of the row
  std::vector<std::uint32_t> cursor_;  // where the next value of the row goes
  UnsetVector<std::uint32_t> values_;
};

/// The rows of all (row, value) with which for_each calls its visitor, the same in both of two
/// calls. It may do so from many threads.
template <class ForEach>
CompressedRows collected_rows(std::uint32_t rows, const ForEach& for_each) {
  RowCollector collector(rows);
  for_each([&](std::uint32_t row, std::uint32_t) { collector.count(row); });
  collector.end_of_counting();
  for_each([&](std::uint32_t row, std::uint32_t value) { collector.add(row, value); });
  return collector.take();
}

}  // namespace isoloop
