// A set of numbers below a bound that knows how many of its members come before each.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace isoloop {

/// Two bits for each number below the bound.
class RankedBits {
 public:
  RankedBits() = default;
  /// Bit i of word w: whether 64 w + i is a member. At most 2^32 - 1 members.
  explicit RankedBits(const std::vector<std::uint64_t>& words) : blocks_(words.size()) {
    for (std::size_t w = 0; w < words.size(); ++w) {
      blocks_[w] = {words[w], count_};
      count_ += static_cast<std::uint32_t>(std::popcount(words[w]));
    }
  }

  std::uint32_t count() const { return count_; }

  bool operator[](std::uint32_t number) const {
    return (blocks_[number / 64].members >> (number % 64) & 1U) != 0;
  }

  /// Bit i: whether `first` + i is a member.
  std::uint64_t bits(std::uint32_t first) const {
    const std::size_t w = first / 64;
    const unsigned shift = first % 64;
    std::uint64_t found = blocks_[w].members >> shift;
    if (shift != 0 && w + 1 < blocks_.size()) found |= blocks_[w + 1].members << (64 - shift);
    return found;
  }

  /// Members below `number`, which may be the bound.
  std::uint32_t rank(std::uint32_t number) const {
    const std::size_t w = number / 64;
    if (w == blocks_.size()) return count_;
    const std::uint64_t before = (std::uint64_t{1} << (number % 64)) - 1;
    return blocks_[w].first +
           static_cast<std::uint32_t>(std::popcount(blocks_[w].members & before));
  }

  std::size_t word_count() const { return blocks_.size(); }

  /// Calls visit(rank, number) for the members from 64 w to 64 w + 63, ascending.
  template <class Visit>
  void visit_word(std::size_t w, const Visit& visit) const {
    std::uint32_t rank = blocks_[w].first;
    for (std::uint64_t left = blocks_[w].members; left != 0; left &= left - 1)
      visit(rank++, static_cast<std::uint32_t>(64 * w) +
                        static_cast<std::uint32_t>(std::countr_zero(left)));
  }

 private:
  struct Block {
    std::uint64_t members = 0;
    std::uint32_t first = 0;  // members in all blocks before
  };
  std::vector<Block> blocks_;
  std::uint32_t count_ = 0;
};

}  // namespace isoloop
