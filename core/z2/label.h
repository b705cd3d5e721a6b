// Labels: sets of generators, added over Z2. Each distinct set is stored once and known by number.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <tbb/parallel_for.h>

namespace isoloop {

/// Generators, ascending.
using GeneratorSet = std::vector<std::uint32_t>;

/// Sum over Z2: what lies in one of the two, but not in both.
GeneratorSet sum_of(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);

/// Numbers sets; equal sets have equal numbers, the empty set is 0. Sums are remembered.
class LabelPool {
 public:
  LabelPool();

  std::uint32_t intern(std::span<const std::uint32_t> generators);  // ascending

  std::uint32_t sum(std::uint32_t a, std::uint32_t b) {
    if (a == 0) return b;
    if (b == 0) return a;
    if (a == b) return 0;
    return sum_of_distinct(a, b);
  }

  /// Valid until the next intern() or sum().
  std::span<const std::uint32_t> generators(std::uint32_t label) const {
    return {members_.data() + first_[label], first_[label + 1] - first_[label]};
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(first_.size() - 1); }

 private:
  std::uint32_t sum_of_distinct(std::uint32_t a, std::uint32_t b);

  std::vector<std::uint32_t> members_;                             // of all sets, one after another
  std::vector<std::size_t> first_;                                 // of each set, and the end
  std::unordered_multimap<std::uint64_t, std::uint32_t> by_hash_;  // of the members
  std::unordered_map<std::uint64_t, std::uint32_t> sums_;          // by lesser << 32 | greater
};

/// A number for each piece, zero for most; pages of zeros are not stored.
class SparseLabels {
 public:
  explicit SparseLabels(std::uint32_t bound) : pages_((std::size_t{bound} >> page_bits) + 1) {}

  std::uint32_t operator[](std::uint32_t piece) const {
    const auto& page = pages_[piece >> page_bits];
    return page.empty() ? 0 : page[piece & page_mask];
  }

  void set(std::uint32_t piece, std::uint32_t label) {
    auto& page = pages_[piece >> page_bits];
    if (page.empty()) page.resize(std::size_t{1} << page_bits);
    page[piece & page_mask] = label;
  }

  /// Calls visit(piece, label) for every label that is not zero, ascending by piece.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t p = 0; p < pages_.size(); ++p) visit_page(p, visit);
  }

  /// The same from many threads at once, in any order.
  template <class Visit>
  void for_each_shared(const Visit& visit) const {
    tbb::parallel_for(std::size_t{0}, pages_.size(), [&](std::size_t p) { visit_page(p, visit); });
  }

  /// Replaces every label by map[label].
  void relabel(std::span<const std::uint32_t> map);

 private:
  template <class Visit>
  void visit_page(std::size_t p, const Visit& visit) const {
    for (std::size_t i = 0; i < pages_[p].size(); ++i)
      if (pages_[p][i] != 0) visit(static_cast<std::uint32_t>(p << page_bits | i), pages_[p][i]);
  }

  static constexpr std::uint32_t page_bits = 10;
  static constexpr std::uint32_t page_mask = (1U << page_bits) - 1;
  std::vector<std::vector<std::uint32_t>> pages_;
};

}  // namespace isoloop
