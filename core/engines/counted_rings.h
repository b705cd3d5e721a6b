// How many pieces round each interior edge are unknown, and which is the last: conclusions without
// walking rings.
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/base/bit_set.h"
#include "core/complex/complex.h"

namespace isoloop {

/// One word for each edge: the sum of the numbers of the unknown pieces round it, and above it how
/// many there are. Where that is 1 the sum is the piece. Both change in one step, so that threads
/// may share the words.
template <Complex C>
class CountedRings {
 public:
  /// Knows `forest`, and all that follows from it: where every piece but one round an edge is
  /// known, so is the last. Which those are does not depend on the order in which they are found.
  CountedRings(const C& complex, BitSet forest)
      : complex_(complex), known_(std::move(forest)), words_(complex.edge_bound()) {
    count_unknown();
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, complex.edge_bound(), 1 << 13),
                      [&](const auto& range) {
                        std::vector<std::uint32_t> todo;
                        for (std::uint32_t edge = range.begin(); edge < range.end(); ++edge)
                          close_from(edge, todo);
                      });
  }

  /// Numbers below complex.piece_bound() that are no piece are known too.
  const BitSet& known() const { return known_; }

  std::uint32_t unknown_round(std::uint32_t edge) const {
    return static_cast<std::uint32_t>(words_[edge] / one);
  }

  /// Where there is one.
  std::uint32_t unknown_at(std::uint32_t edge) const {
    return static_cast<std::uint32_t>(words_[edge] % one);
  }

  /// The piece must be unknown. Not to be called from several threads.
  void set_known(std::uint32_t piece) {
    known_.insert(piece);
    for (const std::uint32_t edge : complex_.edges_of(piece)) words_[edge] -= one + piece;
  }

 private:
  static constexpr std::uint64_t one = std::uint64_t{1} << 40;  // the sum of some pieces is below

  void count_unknown() {
    BitSet is_unknown(complex_.piece_bound());
    tbb::parallel_for(std::uint32_t{0}, complex_.layer_count(), [&](std::uint32_t layer) {
      complex_.for_each_piece(layer, [&](std::uint32_t piece) {
        if (known_[piece]) return;
        is_unknown.insert_shared(piece);
        for (const std::uint32_t edge : complex_.edges_of(piece))
          std::atomic_ref(words_[edge]).fetch_add(one + piece, std::memory_order_relaxed);
      });
    });
    is_unknown.for_each_missing(0, complex_.piece_bound(),
                                [&](std::uint32_t number) { known_.insert(number); });
  }

  void close_from(std::uint32_t edge, std::vector<std::uint32_t>& todo) {
    todo.push_back(edge);
    while (!todo.empty()) {
      const std::uint64_t word =
          std::atomic_ref(words_[todo.back()]).load(std::memory_order_relaxed);
      todo.pop_back();
      if (word / one != 1) continue;
      const auto piece = static_cast<std::uint32_t>(word % one);
      if (!known_.insert_first(piece)) continue;  // another thread was there
      for (const std::uint32_t next : complex_.edges_of(piece)) {
        const std::uint64_t before =
            std::atomic_ref(words_[next]).fetch_sub(one + piece, std::memory_order_relaxed);
        if (before / one == 2) todo.push_back(next);
      }
    }
  }

  const C& complex_;
  BitSet known_;
  std::vector<std::uint64_t> words_;  // by edge
};

}  // namespace isoloop
