// The one total order: by size, then by number.
#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <boost/sort/spreadsort/integer_sort.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/complex.h"

namespace isoloop {

/// Keys compare as their pieces do. Non-negative floats compare as their bit patterns do.
inline std::uint64_t order_key(float size, std::uint32_t piece) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(size)} << 32 | piece;
}

/// Sorts pieces by size, largest first, and among equal sizes by number, largest first: the
/// filtration of the paper read backwards.
template <Complex C>
void sort_from_largest(const C& complex, std::vector<std::uint32_t>& pieces) {
  const std::size_t count = pieces.size();
  std::vector<std::uint64_t> keys(count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1 << 14), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      keys[i] = order_key(complex.size(pieces[i]), pieces[i]);
  });
  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
  for (std::size_t i = 0; i < count; ++i)
    pieces[i] = static_cast<std::uint32_t>(keys[count - 1 - i]);
}

/// All pieces in that order.
template <Complex C>
std::vector<std::uint32_t> pieces_from_largest(const C& complex) {
  std::vector<std::uint32_t> pieces = complex.pieces();
  sort_from_largest(complex, pieces);
  return pieces;
}

}  // namespace isoloop
