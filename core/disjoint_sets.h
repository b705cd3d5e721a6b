// Union-find on 32-bit numbers.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "core/bit_set.h"

namespace isoloop {

/// Links the larger root below the smaller and halves paths: the roots are the least members, so
/// they do not depend on the order of the unions.
class DisjointSets {
 public:
  explicit DisjointSets(std::uint32_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::uint32_t find(std::uint32_t member) {
    while (parent_[member] != member) {
      parent_[member] = parent_[parent_[member]];
      member = parent_[member];
    }
    return member;
  }

  /// False if both were in one set already.
  bool unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (a > b) std::swap(a, b);
    parent_[b] = a;
    return true;
  }

  /// Makes root() valid for all members, until the next union; linear, one pass.
  void flatten() {
    for (std::uint32_t& parent : parent_) parent = parent_[parent];  // parents come first
  }

  /// The number of each member's set, 0, 1, … by least member, for the sets with a root in `roots`;
  /// `count` is set to how many these are. Members of other sets get any number.
  std::vector<std::uint32_t> numbers(const BitSet& roots, std::uint32_t& count) && {
    flatten();
    count = 0;
    for (std::uint32_t member = 0; member < member_count(); ++member) {
      if (parent_[member] != member)
        parent_[member] = parent_[parent_[member]];
      else
        parent_[member] = roots[member] ? count++ : 0;
    }
    return std::move(parent_);
  }

  /// find() after flatten(), or where each member was united with its root itself; may be called
  /// from many threads.
  std::uint32_t root(std::uint32_t member) const { return parent_[member]; }

  std::uint32_t member_count() const { return static_cast<std::uint32_t>(parent_.size()); }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace isoloop
