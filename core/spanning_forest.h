// The spanning forest that Kruskal's algorithm would pick, without sorting the pieces.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include <tbb/parallel_for.h>

#include "core/complex.h"
#include "core/disjoint_sets.h"
#include "core/order.h"

namespace isoloop {

/// A set of numbers below a bound, a bit each.
class BitSet {
 public:
  explicit BitSet(std::uint32_t bound) : words_(std::size_t{bound} / 64 + 1) {}
  bool operator[](std::uint32_t number) const {
    return (words_[number / 64] >> (number % 64) & 1U) != 0;
  }
  void insert(std::uint32_t number) { words_[number / 64] |= std::uint64_t{1} << (number % 64); }

 private:
  std::vector<std::uint64_t> words_;
};

/// The pieces that join two components of cells when all are read in the order of order.h, the
/// largest first: the one greatest spanning forest of the dual graph. Boruvka's rounds (each tree
/// takes the greatest piece on its border; Nesetril, Milkova, Nesetrilova, Discrete Mathematics
/// 233, 2001) walk through memory in order, where Kruskal's walk jumps about, and run in parallel.
template <Complex C>
BitSet largest_forest(const C& complex) {
  BitSet forest(complex.piece_bound());
  DisjointSets trees(complex.cell_bound());
  std::vector<std::uint64_t> greatest(complex.cell_bound());  // by root: key of its greatest piece
  const auto raise = [&](std::uint32_t root, std::uint64_t key) {
    const std::atomic_ref entry(greatest[root]);
    std::uint64_t seen = entry.load(std::memory_order_relaxed);
    while (seen < key && !entry.compare_exchange_weak(seen, key, std::memory_order_relaxed)) {
    }
  };
  // Says whether the piece still joins two trees.
  const auto offer = [&](std::uint32_t piece) {
    const auto [a, b] = complex.cells(piece);
    const std::uint32_t tree_a = trees.root(a);
    const std::uint32_t tree_b = trees.root(b);
    if (tree_a == tree_b) return false;
    const std::uint64_t key = order_key(complex.size(piece), piece) + 1;  // 0 means none
    raise(tree_a, key);
    raise(tree_b, key);
    return true;
  };
  const auto join = [&] {
    bool any = false;
    for (std::uint32_t cell = 0; cell < trees.member_count(); ++cell) {
      if (greatest[cell] == 0) continue;
      const auto piece = static_cast<std::uint32_t>(greatest[cell] - 1);
      greatest[cell] = 0;
      const auto [a, b] = complex.cells(piece);
      if (trees.unite(a, b)) forest.insert(piece);
      any = true;
    }
    trees.flatten();
    return any;
  };
  const std::uint32_t layers = complex.layer_count();
  tbb::parallel_for(std::uint32_t{0}, layers,
                    [&](std::uint32_t layer) { complex.for_each_piece(layer, offer); });
  join();
  std::vector<std::vector<std::uint32_t>> open(layers);  // pieces that join two trees
  tbb::parallel_for(std::uint32_t{0}, layers, [&](std::uint32_t layer) {
    complex.for_each_piece(layer, [&](std::uint32_t piece) {
      if (offer(piece)) open[layer].push_back(piece);
    });
  });
  while (join()) {
    tbb::parallel_for(std::uint32_t{0}, layers, [&](std::uint32_t layer) {
      std::erase_if(open[layer], [&](std::uint32_t piece) { return !offer(piece); });
    });
  }
  return forest;
}

}  // namespace isoloop
