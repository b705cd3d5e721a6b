// The one total order: by size, then by number.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/base/bit_set.h"
#include "core/base/per_thread.h"
#include "core/base/unset_vector.h"
#include "core/complex/complex.h"

namespace isoloop {

/// Keys compare as their pieces do. Non-negative floats compare as their bit patterns do.
inline std::uint64_t order_key(float size, std::uint32_t piece) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(size)} << 32 | piece;
}

/// Sorts keys whose pieces ascend. It looks at the sizes alone, eleven bits at a time: keys of
/// equal sizes stay in the order in which they come, which is that of their pieces.
inline void sort_keys(UnsetVector<std::uint64_t>& keys) {
  constexpr int digits = 3;
  constexpr int digit_bits = 11;  // 33 of a size's 32 in all
  constexpr std::size_t values = std::size_t{1} << digit_bits;
  const auto digit_of = [](std::uint64_t key, int digit) {
    return key >> (32 + digit * digit_bits) & (values - 1);
  };
  std::vector<std::array<std::size_t, values>> counts(digits);
  for (const std::uint64_t key : keys)
    for (int d = 0; d < digits; ++d) ++counts[d][digit_of(key, d)];
  UnsetVector<std::uint64_t> sorted(keys.size());
  for (int d = 0; d < digits; ++d) {
    std::exclusive_scan(counts[d].begin(), counts[d].end(), counts[d].begin(), std::size_t{0});
    for (const std::uint64_t key : keys) sorted[counts[d][digit_of(key, d)]++] = key;
    std::swap(keys, sorted);
  }
}

/// Calls visit(piece, its size) for the pieces of a layer, ascending.
template <DualGraph C, PieceSizes S, class Visit>
void for_each_sized(const C& complex, const S& sizes, std::uint32_t layer, const Visit& visit) {
  complex.for_each_piece(layer, [&](std::uint32_t piece) { visit(piece, sizes.of_piece(piece)); });
}

/// The same for those pieces of a layer, at least, that cells of the layer before may touch.
template <DualGraph C, PieceSizes S, class Visit>
void for_each_sized_beside(const C& complex, const S& sizes, std::uint32_t layer,
                           const Visit& visit) {
  for_each_sized(complex, sizes, layer, visit);
}

/// The pieces, which ascend, by size, largest first, and among equal sizes by number, largest
/// first: the filtration of the paper read backwards.
template <PieceSizes S>
std::vector<std::uint32_t> from_largest(const S& sizes, std::vector<std::uint32_t> pieces) {
  const std::size_t count = pieces.size();
  UnsetVector<std::uint64_t> keys(count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1 << 14), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      keys[i] = order_key(sizes.of_piece(pieces[i]), pieces[i]);
  });
  sort_keys(keys);
  for (std::size_t i = 0; i < count; ++i)
    pieces[i] = static_cast<std::uint32_t>(keys[count - 1 - i]);
  return pieces;
}

/// The pieces below `bound` that are missing in `known`, in that order, down to some size: the
/// largest eighth of them or more, and all where they are few. Halves, at least, what sorting them
/// all would hold in memory.
template <PieceSizes S>
std::vector<std::uint32_t> largest_missing(const S& sizes, std::uint32_t bound,
                                           const BitSet& known) {
  constexpr std::size_t few = 1 << 16;
  constexpr int dropped_bits = 16;  // of a size: what is left are its exponent and 7 bits more
  constexpr std::uint32_t chunk = 1 << 18;  // numbers of pieces
  const auto bin = [&](std::uint32_t piece) {
    return std::bit_cast<std::uint32_t>(sizes.of_piece(piece)) >> dropped_bits;
  };
  std::vector<std::vector<std::uint32_t>> chunks(bound / chunk + 1);
  const auto for_each_missing = [&](std::size_t c, const auto& visit) {
    const auto begin = static_cast<std::uint32_t>(c) * chunk;
    known.for_each_missing(begin, begin + std::min(chunk, bound - begin), visit);
  };
  std::vector<std::uint32_t> in_bin(std::size_t{1} << (31 - dropped_bits));  // no size has a sign
  PerThread<std::vector<std::uint32_t>> counters;
  tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t c) {
    std::vector<std::uint32_t>& counted = counters.local([&] { return in_bin; });
    for_each_missing(c, [&](std::uint32_t piece) { ++counted[bin(piece)]; });
  });
  counters.for_each([&](const std::vector<std::uint32_t>& counted) {
    std::transform(counted.begin(), counted.end(), in_bin.begin(), in_bin.begin(), std::plus<>{});
  });
  const auto missing = std::accumulate(in_bin.begin(), in_bin.end(), std::size_t{0});
  std::size_t least = in_bin.size();
  std::size_t count = 0;
  while (count < missing && (count < few || count < missing / 8)) count += in_bin[--least];
  tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t c) {
    for_each_missing(c, [&](std::uint32_t piece) {
      if (bin(piece) >= least) chunks[c].push_back(piece);
    });
  });
  std::vector<std::uint32_t> pieces;
  pieces.reserve(count);
  for (const std::vector<std::uint32_t>& each : chunks)
    pieces.insert(pieces.end(), each.begin(), each.end());
  chunks = std::vector<std::vector<std::uint32_t>>();  // before the keys come
  return from_largest(sizes, std::move(pieces));
}

}  // namespace isoloop
