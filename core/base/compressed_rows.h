// Lists of numbers, gathered by many threads.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/unset_vector.h"

namespace isoloop {

/// Row r: values[first[r]] .. values[first[r+1]-1].
struct CompressedRows {
  std::vector<std::uint32_t> first;  // size: rows + 1
  UnsetVector<std::uint32_t> values;
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

}  // namespace isoloop
