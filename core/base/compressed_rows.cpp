#include "core/base/compressed_rows.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include <tbb/parallel_for.h>

namespace isoloop {

RowCollector::RowCollector(std::uint32_t rows) : first_(std::size_t{rows} + 1) {}

void RowCollector::count(std::uint32_t row) {
  std::atomic_ref(first_[row + 1]).fetch_add(1, std::memory_order_relaxed);
}

void RowCollector::end_of_counting() {
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  cursor_.assign(first_.begin(), first_.end() - 1);
  values_.resize(first_.back());
}

void RowCollector::add(std::uint32_t row, std::uint32_t value) {
  values_[std::atomic_ref(cursor_[row]).fetch_add(1, std::memory_order_relaxed)] = value;
}

CompressedRows RowCollector::take() {
  const auto count = static_cast<std::uint32_t>(cursor_.size());
  tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t row) {
    const auto begin = values_.begin() + first_[row];
    const auto end = values_.begin() + first_[row + 1];
    std::sort(begin, end);
    cursor_[row] = static_cast<std::uint32_t>(std::unique(begin, end) - begin);
  });
  CompressedRows rows;
  rows.first.resize(std::size_t{count} + 1);
  std::partial_sum(cursor_.begin(), cursor_.end(), rows.first.begin() + 1);
  rows.values.resize(rows.first.back());
  tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t row) {
    std::copy_n(values_.begin() + first_[row], cursor_[row], rows.values.begin() + rows.first[row]);
  });
  return rows;
}

}  // namespace isoloop
