// Finds the vertex of M on a cut grid edge in constant time and half a byte a grid vertex, and four
// bytes a vertex of M.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/sides.h"

namespace isoloop {

/// Numbers M's vertices by their cut edges: bricks of the lattice one after another along Morton's
/// curve, so that neighbours on M lie close in memory; within a brick in scan order. Hence of two
/// vertices in one row of the lattice the one with the lesser x comes first.
class EdgeIndex {
 public:
  explicit EdgeIndex(const Sides& sides);

  std::uint32_t count() const { return count_; }

  bool is_cut(std::uint32_t grid_edge) const {
    const std::uint32_t v = grid_edge / 3;
    return (blocks_[v / 64].cut[grid_edge % 3] >> (v % 64) & 1U) != 0;
  }

  /// `grid_edge` must be cut.
  std::uint32_t vertex_on(std::uint32_t grid_edge) const {
    const std::uint32_t v = grid_edge / 3;
    const std::uint32_t axis = grid_edge - 3 * v;
    const Block& block = blocks_[v / 64];
    const std::uint64_t before = (std::uint64_t{1} << (v % 64)) - 1;
    std::uint32_t rank = block.first;
    for (std::uint32_t a = 0; a < 3; ++a) {
      rank += static_cast<std::uint32_t>(std::popcount(block.cut[a] & before));
      if (a < axis) rank += static_cast<std::uint32_t>(block.cut[a] >> (v % 64) & 1U);
    }
    return number_[rank];
  }

  /// Calls visit(vertex of M, grid edge) for the cut edges at lattice vertices 64 b .. 64 b + 63.
  template <class Visit>
  void visit_block(std::uint32_t b, const Visit& visit) const {
    const Block& block = blocks_[b];
    std::uint32_t rank = block.first;
    for (std::uint64_t left = block.cut[0] | block.cut[1] | block.cut[2]; left != 0;
         left &= left - 1) {
      const auto bit = static_cast<std::uint32_t>(std::countr_zero(left));
      for (std::uint32_t a = 0; a < 3; ++a)
        if ((block.cut[a] >> bit & 1U) != 0) visit(number_[rank++], 3 * (64 * b + bit) + a);
    }
  }

  std::uint32_t block_count() const { return static_cast<std::uint32_t>(blocks_.size()); }

 private:
  struct Block {
    std::array<std::uint64_t, 3> cut{};  // by axis: bit i is the edge at lattice vertex 64 b + i
    std::uint32_t first = 0;             // cut edges in all blocks before
  };
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> number_;  // of M's vertices, by the rank of the cut edge in scan order
  std::uint32_t count_ = 0;
};

}  // namespace isoloop
