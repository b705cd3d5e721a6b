// The spanning forest that Kruskal's algorithm would pick, without sorting the pieces.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include <tbb/parallel_for.h>

#include "core/bit_set.h"
#include "core/complex.h"
#include "core/disjoint_sets.h"
#include "core/order.h"

namespace isoloop {

/// Boruvka's rounds within some layers of cells: a tree takes the greatest piece on its border as
/// long as that leads to another tree of these layers.
template <Complex C>
class ForestOfLayers {
 public:
  /// `is_bound`: cells with pieces outside their own layer and the next, whose trees take none.
  ForestOfLayers(const C& complex, std::uint32_t begin, std::uint32_t end, DisjointSets& trees,
                 const BitSet& is_bound)
      : complex_(complex),
        begin_(begin),
        end_(end),
        first_(complex.first_cell(begin)),
        last_(complex.first_cell(end)),
        trees_(trees),
        greatest_(last_ - first_),
        is_bound_(last_ - first_) {
    for (std::uint32_t cell = first_; cell < last_; ++cell)
      is_bound_[cell - first_] = is_bound[cell];
  }

  /// Adds to `forest`. Returns the pieces of these layers that still join two trees, of these
  /// layers or others.
  std::vector<std::uint32_t> grow(BitSet& forest) {
    offer_all([](std::uint32_t) {});
    join(forest);
    std::vector<std::uint32_t> open;
    offer_all([&](std::uint32_t piece) { open.push_back(piece); });
    while (join(forest) > (last_ - first_) / worthwhile)
      std::erase_if(open, [&](std::uint32_t piece) { return !offer(piece); });
    std::erase_if(open, [&](std::uint32_t piece) {
      const auto [a, b] = complex_.cells(piece);
      return piece >= end_of_own_ || tree(a) == tree(b);
    });
    open.shrink_to_fit();
    return open;
  }

 private:
  static constexpr std::uint32_t worthwhile = 256;  // share of the cells that a round must join

  bool is_local(std::uint32_t cell) const { return cell - first_ < last_ - first_; }

  std::uint32_t tree(std::uint32_t cell) const { return is_local(cell) ? trees_.root(cell) : cell; }

  /// Calls keep(piece) for every piece that touches these layers and joins two trees.
  template <class Keep>
  void offer_all(const Keep& keep) {
    for (std::uint32_t layer = begin_; layer < std::min(end_ + 1, complex_.layer_count()); ++layer)
      complex_.for_each_piece(layer, [&](std::uint32_t piece) {
        if (layer == end_) end_of_own_ = std::min(end_of_own_, piece);
        if (offer(piece)) keep(piece);
      });
  }

  /// Says whether the piece joins two trees.
  bool offer(std::uint32_t piece) {
    const auto [a, b] = complex_.cells(piece);
    const std::uint32_t tree_a = tree(a);
    const std::uint32_t tree_b = tree(b);
    if (tree_a == tree_b) return false;
    const std::uint64_t key = order_key(complex_.size(piece), piece) + 1;  // 0 means none
    for (const std::uint32_t root : {tree_a, tree_b})
      if (is_local(root)) greatest_[root - first_] = std::max(greatest_[root - first_], key);
    return true;
  }

  std::uint32_t join(BitSet& forest) {
    std::uint32_t joined = 0;
    for (std::uint32_t cell = first_; cell < last_; ++cell) {
      const std::uint64_t key = greatest_[cell - first_];
      greatest_[cell - first_] = 0;
      if (key == 0 || is_bound_[cell - first_] != 0) continue;
      const auto piece = static_cast<std::uint32_t>(key - 1);
      const auto [a, b] = complex_.cells(piece);
      if (!is_local(a) || !is_local(b)) continue;
      const std::uint32_t tree_a = trees_.find(a);
      const std::uint32_t tree_b = trees_.find(b);
      if (!trees_.unite(tree_a, tree_b)) continue;
      is_bound_[std::min(tree_a, tree_b) - first_] |= is_bound_[std::max(tree_a, tree_b) - first_];
      forest.insert_shared(piece);
      ++joined;
    }
    trees_.flatten(first_, last_);
    return joined;
  }

  const C& complex_;
  std::uint32_t begin_;  // layers
  std::uint32_t end_;
  std::uint32_t first_;  // cells
  std::uint32_t last_;
  std::uint32_t end_of_own_ = static_cast<std::uint32_t>(-1);  // the first piece of the layer after
  DisjointSets& trees_;
  std::vector<std::uint64_t> greatest_;  // by root: key of its greatest piece
  std::vector<std::uint8_t> is_bound_;   // by root
};

/// Boruvka's rounds on what is left: `trees` as nodes, joined by the pieces in `open`.
template <Complex C>
void join_trees(const C& complex, const std::vector<std::uint32_t>& tree_of_cell,
                std::uint32_t tree_count, std::vector<std::vector<std::uint32_t>>& open,
                BitSet& forest) {
  DisjointSets trees(tree_count);
  std::vector<std::uint64_t> greatest(tree_count);  // by root: key of its greatest piece
  const auto raise = [&](std::uint32_t root, std::uint64_t key) {
    const std::atomic_ref entry(greatest[root]);
    std::uint64_t seen = entry.load(std::memory_order_relaxed);
    while (seen < key && !entry.compare_exchange_weak(seen, key, std::memory_order_relaxed)) {
    }
  };
  // Says whether the piece still joins two trees.
  const auto offer = [&](std::uint32_t piece) {
    const auto [a, b] = complex.cells(piece);
    const std::uint32_t tree_a = trees.root(tree_of_cell[a]);
    const std::uint32_t tree_b = trees.root(tree_of_cell[b]);
    if (tree_a == tree_b) return false;
    const std::uint64_t key = order_key(complex.size(piece), piece) + 1;  // 0 means none
    raise(tree_a, key);
    raise(tree_b, key);
    return true;
  };
  for (bool any = true; any;) {
    tbb::parallel_for(std::size_t{0}, open.size(), [&](std::size_t i) {
      std::erase_if(open[i], [&](std::uint32_t piece) { return !offer(piece); });
    });
    any = false;
    for (std::uint32_t tree = 0; tree < tree_count; ++tree) {
      if (greatest[tree] == 0) continue;
      const auto piece = static_cast<std::uint32_t>(greatest[tree] - 1);
      greatest[tree] = 0;
      const auto [a, b] = complex.cells(piece);
      if (trees.unite(tree_of_cell[a], tree_of_cell[b])) forest.insert(piece);
      any = true;
    }
    trees.flatten();
  }
}

/// The pieces that join two components of cells when all are read in the order of order.h, the
/// largest first: the one greatest spanning forest of the dual graph. Boruvka's rounds (each tree
/// takes the greatest piece on its border; Nesetril, Milkova, Nesetrilova, Discrete Mathematics
/// 233, 2001), first within slabs of a few layers each, then between what these come to: such
/// rounds walk through little memory, in order, where Kruskal's walk jumps about.
template <Complex C>
BitSet largest_forest(const C& complex) {
  constexpr std::uint32_t slab = 8;  // layers
  BitSet forest(complex.piece_bound());
  DisjointSets cells(complex.cell_bound());
  const std::uint32_t layers = complex.layer_count();
  BitSet is_bound(complex.cell_bound());
  const std::uint32_t slabs = (layers - 1 + slab - 1) / slab;
  std::vector<std::vector<std::uint32_t>> open(slabs + 1);
  complex.for_each_piece(layers - 1, [&](std::uint32_t piece) {
    open[slabs].push_back(piece);
    for (const std::uint32_t cell : complex.cells(piece)) is_bound.insert(cell);
  });
  tbb::parallel_for(std::uint32_t{0}, slabs, [&](std::uint32_t s) {
    const std::uint32_t end = std::min((s + 1) * slab, layers - 1);
    open[s] = ForestOfLayers<C>(complex, s * slab, end, cells, is_bound).grow(forest);
  });
  // Most trees are single cells of the other side, which nothing touches.
  BitSet touched(complex.cell_bound());
  tbb::parallel_for(std::size_t{0}, open.size(), [&](std::size_t i) {
    for (const std::uint32_t piece : open[i])
      for (const std::uint32_t cell : complex.cells(piece)) touched.insert_shared(cells.root(cell));
  });
  std::uint32_t tree_count = 0;
  const std::vector<std::uint32_t> tree_of_cell = std::move(cells).numbers(touched, tree_count);
  join_trees(complex, tree_of_cell, tree_count, open, forest);
  return forest;
}

}  // namespace isoloop
