// The one column of a boundary matrix that is being reduced over Z2.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoloop {

/// A set of rows below a bound, as a tree of 64-bit words: a bit above says whether the word below
/// it is not 0. Flipping a row and finding the youngest (the greatest) take a step a level, six at
/// most ("bit tree" of Bauer, Kerber, Reininghaus, Wagner, PHAT, JSC 78, 2017).
class BitColumn {
 public:
  explicit BitColumn(std::uint32_t bound);

  void flip(std::uint32_t row) {
    std::size_t at = row;
    for (std::vector<std::uint64_t>& level : levels_) {
      std::uint64_t& word = level[at / 64];
      const bool was_empty = word == 0;
      word ^= std::uint64_t{1} << (at % 64);
      if (was_empty == (word == 0)) return;
      at /= 64;
    }
  }

  bool holds(std::uint32_t row) const { return (levels_[0][row / 64] >> (row % 64) & 1U) != 0; }

  bool empty() const { return levels_.back()[0] == 0; }

  /// Must not be empty.
  std::uint32_t youngest() const {
    std::size_t at = 0;
    for (std::size_t l = levels_.size(); l-- > 0;)
      at = 64 * at + 63 - static_cast<std::size_t>(std::countl_zero(levels_[l][at]));
    return static_cast<std::uint32_t>(at);
  }

  /// Appends the rows to `rows`, youngest first, and empties the column.
  void drain(std::vector<std::uint32_t>& rows);

 private:
  std::vector<std::vector<std::uint64_t>> levels_;  // the last has one word
};

}  // namespace isoloop
