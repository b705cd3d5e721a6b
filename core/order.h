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

/// All pieces, largest size first and, among equal sizes, largest number first: the filtration of
/// the paper read backwards.
template <Complex C>
std::vector<std::uint32_t> pieces_from_largest(const C& complex) {
  std::vector<std::uint32_t> pieces = complex.pieces();
  std::vector<std::uint64_t> keys(pieces.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, pieces.size(), 1 << 14), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          // Non-negative floats compare as their bit patterns do.
          keys[i] = std::uint64_t{std::bit_cast<std::uint32_t>(complex.size(pieces[i]))} << 32 |
                    pieces[i];
      });
  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
  const std::size_t count = pieces.size();
  for (std::size_t i = 0; i < count; ++i)
    pieces[i] = static_cast<std::uint32_t>(keys[count - 1 - i]);
  return pieces;
}

}  // namespace isoloop
