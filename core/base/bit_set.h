// A set of numbers below a bound, a bit each.
#pragma once

#include <atomic>
#include <bit>
#include <cstdint>
#include <vector>

namespace isoloop {

class BitSet {
 public:
  explicit BitSet(std::uint32_t bound) : words_(std::size_t{bound} / 64 + 1) {}

  bool operator[](std::uint32_t number) const {
    return (words_[number / 64] >> (number % 64) & 1U) != 0;
  }

  void insert(std::uint32_t number) { words_[number / 64] |= std::uint64_t{1} << (number % 64); }

  /// insert() that other threads may call at the same time.
  void insert_shared(std::uint32_t number) {
    const std::atomic_ref word(words_[number / 64]);
    word.fetch_or(std::uint64_t{1} << (number % 64), std::memory_order_relaxed);
  }

  /// insert_shared(); true for one of the calls that insert a number.
  bool insert_first(std::uint32_t number) {
    const std::uint64_t bit = std::uint64_t{1} << (number % 64);
    const std::atomic_ref word(words_[number / 64]);
    return (word.fetch_or(bit, std::memory_order_relaxed) & bit) == 0;
  }

  /// Calls visit(number) for every number from `begin`, a multiple of 64, up to `end`, itself not
  /// included, that is not in the set, ascending.
  template <class Visit>
  void for_each_missing(std::uint32_t begin, std::uint32_t end, const Visit& visit) const {
    for (std::size_t w = begin / 64; w * 64 < end; ++w)
      for (std::uint64_t missing = ~words_[w]; missing != 0; missing &= missing - 1) {
        const std::uint64_t number = w * 64 + static_cast<unsigned>(std::countr_zero(missing));
        if (number >= end) return;
        visit(static_cast<std::uint32_t>(number));
      }
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace isoloop
