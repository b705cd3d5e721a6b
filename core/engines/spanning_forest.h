// The spanning forest that Kruskal's algorithm would pick, without sorting all pieces.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/base/bit_set.h"
#include "core/base/disjoint_sets.h"
#include "core/base/threads.h"
#include "core/base/unset_vector.h"
#include "core/complex/complex.h"
#include "core/complex/order.h"

namespace isoloop {

/// Kruskal's walk through the pieces of some layers of cells, and what of it holds for the whole
/// complex. A piece that closes a cycle of larger ones is in no largest forest; one that is the
/// largest on the border of a tree is in it. Whether it is can be told here unless both trees that
/// it joins are bound: may have a larger piece on their border, one that leads out of these layers.
template <DualGraph C, PieceSizes S>
class ForestOfLayers {
 public:
  /// `is_bound`: cells with pieces in the last layer.
  ForestOfLayers(const C& complex, const S& sizes, std::uint32_t begin, std::uint32_t end,
                 const BitSet& is_bound)
      : complex_(complex),
        sizes_(sizes),
        begin_(begin),
        end_(end),
        first_(complex.first_cell(begin)),
        last_(complex.first_cell(end)),
        joined_(last_ - first_),
        trees_(last_ - first_),
        is_bound_(last_ - first_) {
    for (std::uint32_t cell = first_; cell < last_; ++cell) is_bound_[local(cell)] = is_bound[cell];
  }

  /// Adds to `forest`, and sets the entries of these layers' cells in `tree_of_cell`: the greatest
  /// cell of their tree. Returns the pieces of these layers that may be in the forest as well.
  std::vector<std::uint32_t> grow(BitSet& forest, std::span<std::uint32_t> tree_of_cell) {
    UnsetVector<std::uint64_t> sized;  // keys
    std::vector<std::uint32_t> unsized;
    const auto add = [&](std::uint32_t piece, float size) {
      if (size > 0.0F)
        sized.push_back(order_key(size, piece));
      else
        unsized.push_back(piece);
    };
    for (std::uint32_t layer = begin_; layer < end_; ++layer)
      for_each_sized(complex_, sizes_, layer, add);
    if (end_ + 1 < complex_.layer_count())
      for_each_sized_beside(complex_, sizes_, end_, [&](std::uint32_t piece, float size) {
        end_of_own_ = std::min(end_of_own_, piece);
        if (touches(piece)) add(piece, size);
      });
    sort_keys(sized);
    std::vector<std::uint32_t> open;
    for (std::size_t i = sized.size(); i-- > 0;)
      take(static_cast<std::uint32_t>(sized[i]), forest, open);
    for (std::size_t i = unsized.size(); i-- > 0;) take(unsized[i], forest, open);
    open.shrink_to_fit();
    for (std::uint32_t cell = first_; cell < last_; ++cell)
      tree_of_cell[cell] = last_ - 1 - trees_.find(local(cell));
    return open;
  }

 private:
  bool is_local(std::uint32_t cell) const { return cell - first_ < last_ - first_; }

  bool touches(std::uint32_t piece) const {
    const auto [a, b] = complex_.cells(piece);
    return is_local(a) || is_local(b);
  }

  /// Backwards: of equal sizes the greatest numbers are met first, so that the root of a set, its
  /// least member, seldom changes.
  std::uint32_t local(std::uint32_t cell) const { return last_ - 1 - cell; }

  /// To be called with the largest piece first.
  void take(std::uint32_t piece, BitSet& forest, std::vector<std::uint32_t>& open) {
    const auto [a, b] = complex_.cells(piece);
    if (!is_local(a) || !is_local(b)) {
      for (const std::uint32_t cell : {a, b})
        if (is_local(cell)) is_bound_[trees_.find(local(cell))] = 1;
      if (a != b && piece < end_of_own_) open.push_back(piece);
      return;
    }
    if (!joined_.unite(local(a), local(b))) return;
    const std::uint32_t tree_a = trees_.find(local(a));
    const std::uint32_t tree_b = trees_.find(local(b));
    if (is_bound_[tree_a] != 0 && is_bound_[tree_b] != 0) {
      open.push_back(piece);
      return;
    }
    is_bound_[std::min(tree_a, tree_b)] |= is_bound_[std::max(tree_a, tree_b)];
    trees_.unite(tree_a, tree_b);
    forest.insert_shared(piece);
  }

  const C& complex_;
  const S& sizes_;
  std::uint32_t begin_;  // layers
  std::uint32_t end_;
  std::uint32_t first_;  // cells
  std::uint32_t last_;
  std::uint32_t end_of_own_ = static_cast<std::uint32_t>(-1);  // the first piece of the layer after
  DisjointSets joined_;                                        // by the pieces so far
  DisjointSets trees_;                                         // of the forest
  std::vector<std::uint8_t> is_bound_;                         // by root of a tree
};

/// Gives the trees that have an open piece on their border the numbers 0, 1, ..., and returns how
/// many there are. On entry `tree_of_cell` names the greatest cell of each cell's tree, which lies
/// in the same one of `ranges` as the cell; on return it has the tree's number, or any value if the
/// tree has no open piece.
inline std::uint32_t number_trees(const BitSet& touched, std::span<const std::uint32_t> ranges,
                                  std::span<std::uint32_t> tree_of_cell) {
  const std::size_t count = ranges.size() - 1;
  std::vector<std::uint32_t> first(count + 1);
  const auto is_tree = [&](std::uint32_t cell) {
    return tree_of_cell[cell] == cell && touched[cell];
  };
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t r) {
    for (std::uint32_t cell = ranges[r]; cell < ranges[r + 1]; ++cell)
      first[r + 1] += is_tree(cell) ? 1 : 0;
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t r) {
    std::uint32_t next = first[r];
    for (std::uint32_t cell = ranges[r + 1]; cell-- > ranges[r];) {
      const std::uint32_t root = tree_of_cell[cell];
      tree_of_cell[cell] = is_tree(cell) ? next++ : root == cell ? 0 : tree_of_cell[root];
    }
  });
  return first.back();
}

/// Boruvka's rounds on what is left: `trees` as nodes, joined by the pieces in `open`.
template <DualGraph C, PieceSizes S>
void join_trees(const C& complex, const S& sizes, std::span<const std::uint32_t> tree_of_cell,
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
    const std::uint32_t tree_a = trees.find_shared(tree_of_cell[a]);
    const std::uint32_t tree_b = trees.find_shared(tree_of_cell[b]);
    if (tree_a == tree_b) return false;
    const std::uint64_t key = order_key(sizes.of_piece(piece), piece) + 1;  // 0 means none
    raise(tree_a, key);
    raise(tree_b, key);
    return true;
  };
  const auto take = [&](std::uint32_t piece) {
    const auto [a, b] = complex.cells(piece);
    if (trees.unite_shared(tree_of_cell[a], tree_of_cell[b])) forest.insert_shared(piece);
  };
  for (std::atomic<bool> any = true; any;) {
    tbb::parallel_for(std::size_t{0}, open.size(), [&](std::size_t i) {
      std::erase_if(open[i], [&](std::uint32_t piece) { return !offer(piece); });
    });
    any = false;
    const tbb::blocked_range<std::uint32_t> all(0, tree_count, 1 << 12);
    tbb::parallel_for(all, [&](const auto& range) {
      bool any_here = false;
      for (std::uint32_t tree = range.begin(); tree < range.end(); ++tree) {
        if (greatest[tree] == 0) continue;
        take(static_cast<std::uint32_t>(greatest[tree] - 1));
        greatest[tree] = 0;
        any_here = true;
      }
      if (any_here) any = true;
    });
  }
}

/// How many layers a slab of largest_forest() has; `threads`: at least 1.
inline std::uint32_t layers_in_slab(std::uint32_t layers, std::size_t threads) {
  constexpr std::uint32_t least = 2;  // one alone leaves most to the rounds
  constexpr std::uint32_t largest = 8;
  // All slabs at hand have a sixth of the layers, unless they are of the least size.
  constexpr std::size_t share = 6;
  return static_cast<std::uint32_t>(
      std::clamp<std::size_t>(layers / (share * threads), least, largest));
}

/// Bytes that largest_forest() takes for the slabs at hand and for the rounds at most; `layers` and
/// `threads`: at least 1.
inline std::uint64_t slab_bytes(std::uint64_t cells, std::uint32_t layers, std::size_t threads) {
  const std::uint32_t slab = layers_in_slab(layers, threads);
  const std::uint64_t at_hand = std::min<std::uint64_t>(layers, slab * threads);
  return cells * 84 / layers * at_hand + cells * 12 / slab;
}

/// The pieces that join two components of cells when all are read in the order of order.h, the
/// largest first: the one greatest spanning forest of the dual graph. Kruskal's walk within slabs
/// of a few layers each, which walks through little memory and mostly in order, then Boruvka's
/// rounds between what these come to (each tree takes the greatest piece on its border; Nesetril,
/// Milkova, Nesetrilova, Discrete Mathematics 233, 2001).
template <DualGraph C, PieceSizes S>
BitSet largest_forest(const C& complex, const S& sizes) {
  const std::uint32_t layers = complex.layer_count();
  const std::uint32_t slab = layers_in_slab(layers, thread_count());
  BitSet forest(complex.piece_bound());
  BitSet is_bound(complex.cell_bound());
  const std::uint32_t slabs = (layers - 1 + slab - 1) / slab;
  std::vector<std::vector<std::uint32_t>> open(slabs + 1);
  complex.for_each_piece(layers - 1, [&](std::uint32_t piece) {
    open[slabs].push_back(piece);
    for (const std::uint32_t cell : complex.cells(piece)) is_bound.insert(cell);
  });
  std::vector<std::uint32_t> ranges(slabs + 2, complex.cell_bound());  // of cells: by slab, others
  for (std::uint32_t s = 0; s <= slabs; ++s)
    ranges[s] = complex.first_cell(std::min(s * slab, layers - 1));
  UnsetVector<std::uint32_t> tree_of_cell(complex.cell_bound());
  tbb::parallel_for(std::uint32_t{0}, slabs, [&](std::uint32_t s) {
    const std::uint32_t end = std::min((s + 1) * slab, layers - 1);
    open[s] =
        ForestOfLayers<C, S>(complex, sizes, s * slab, end, is_bound).grow(forest, tree_of_cell);
  });
  std::iota(tree_of_cell.begin() + ranges[slabs], tree_of_cell.end(), ranges[slabs]);
  // Most trees are single cells of the other side, which nothing touches.
  BitSet touched(complex.cell_bound());
  tbb::parallel_for(std::size_t{0}, open.size(), [&](std::size_t i) {
    for (const std::uint32_t piece : open[i])
      for (const std::uint32_t cell : complex.cells(piece))
        touched.insert_shared(tree_of_cell[cell]);
  });
  const std::uint32_t tree_count = number_trees(touched, ranges, tree_of_cell);
  join_trees(complex, sizes, tree_of_cell, tree_count, open, forest);
  return forest;
}

}  // namespace isoloop
