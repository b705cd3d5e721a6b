// Labels: sets of generators, added over Z2. Each distinct set is stored once and known by number.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <tbb/blocked_range.h>
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

/// A number for each piece, zero for most. Pages of 64 are stored where one is not zero: the pieces
/// of a surface are few in each.
class SparseLabels {
 public:
  explicit SparseLabels(std::uint32_t bound) : pages_((std::size_t{bound} >> page_bits) + 1) {}

  std::uint32_t operator[](std::uint32_t piece) const {
    const std::uint32_t page = pages_[piece >> page_bits];
    return page == 0 ? 0 : page_at(page)[piece & page_mask];
  }

  void set(std::uint32_t piece, std::uint32_t label) {
    std::uint32_t& page = pages_[piece >> page_bits];
    if (page == 0) {
      if (used_ % chunk_pages == 0) chunks_.emplace_back(chunk_pages << page_bits);
      page = ++used_;
    }
    chunks_[(page - 1) / chunk_pages][first_in_chunk(page) + (piece & page_mask)] = label;
  }

  /// Calls visit(piece, label) for every label that is not zero, ascending by piece.
  template <class Visit>
  void for_each(const Visit& visit) const {
    visit_pages(0, pages_.size(), visit);
  }

  /// The same from many threads at once, in any order.
  template <class Visit>
  void for_each_shared(const Visit& visit) const {
    const tbb::blocked_range<std::size_t> all(0, pages_.size(), 64);
    tbb::parallel_for(all,
                      [&](const auto& range) { visit_pages(range.begin(), range.end(), visit); });
  }

  /// Replaces every label by map[label]; map[0] is 0.
  void relabel(std::span<const std::uint32_t> map);

 private:
  static constexpr std::uint32_t page_bits = 6;
  static constexpr std::uint32_t page_mask = (1U << page_bits) - 1;
  static constexpr std::uint32_t chunk_pages = 256;

  static std::uint32_t first_in_chunk(std::uint32_t page) {
    return (page - 1) % chunk_pages << page_bits;
  }
  const std::uint32_t* page_at(std::uint32_t page) const {
    return chunks_[(page - 1) / chunk_pages].data() + first_in_chunk(page);
  }

  template <class Visit>
  void visit_pages(std::size_t begin, std::size_t end, const Visit& visit) const {
    for (std::size_t p = begin; p < end; ++p) {
      if (pages_[p] == 0) continue;
      const std::uint32_t* const labels = page_at(pages_[p]);
      for (std::uint32_t i = 0; i <= page_mask; ++i)
        if (labels[i] != 0) visit(static_cast<std::uint32_t>(p << page_bits | i), labels[i]);
    }
  }

  std::vector<std::uint32_t> pages_;  // by piece: the number of the page from 1 on, or 0
  std::uint32_t used_ = 0;            // pages
  std::vector<std::vector<std::uint32_t>> chunks_;  // of pages: none ever moves
};

}  // namespace isoloop
