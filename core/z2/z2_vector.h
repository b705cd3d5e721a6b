// A vector over Z2, whose elements that are 1 stand in a list or, where that is shorter, as bits.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/z2/label.h"

namespace isoloop {

/// The bits of a set below n take n / 8 bytes, its list 4 bytes an element: a vector of few
/// elements stays a list however large their numbers are, and one of many adds 64 at a time.
class Z2Vector {
 public:
  Z2Vector() = default;
  explicit Z2Vector(std::span<const std::uint32_t> ones);  // ascending

  void add(const Z2Vector& other);

  /// The greatest element that is 1 and less than `bound`.
  std::optional<std::uint32_t> greatest_below(std::uint64_t bound) const;

  /// The greatest of all.
  std::optional<std::uint32_t> greatest() const;

  /// Those that are 1, ascending.
  GeneratorSet ones() const;

 private:
  bool is_list() const { return bits_.empty(); }
  void add_listed(std::span<const std::uint32_t> ones);
  void become_bits();
  void flip(std::uint32_t element);

  GeneratorSet list_;                // empty where there are bits
  GeneratorSet spare_;               // for the next sum of lists
  std::vector<std::uint64_t> bits_;  // of words of 64; empty where there is a list
};

}  // namespace isoloop
