// Finds the vertex of M on a cut grid edge in constant time and half a byte a grid vertex.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/sides.h"

namespace isoloop {

/// Ranks the cut edges of the lattice in scan order: by vertex, then by axis. The rank of an edge
/// is the number of its vertex on M.
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
    return rank;
  }

  /// Calls visit(first vertex of M, grid edge) for the cut edges at lattice vertices 64 b .. 64 b
  /// + 63.
  template <class Visit>
  void visit_block(std::uint32_t b, const Visit& visit) const {
    const Block& block = blocks_[b];
    std::uint32_t rank = block.first;
    for (std::uint64_t left = block.cut[0] | block.cut[1] | block.cut[2]; left != 0;
         left &= left - 1) {
      const auto bit = static_cast<std::uint32_t>(std::countr_zero(left));
      for (std::uint32_t a = 0; a < 3; ++a)
        if ((block.cut[a] >> bit & 1U) != 0) visit(rank++, 3 * (64 * b + bit) + a);
    }
  }

  std::uint32_t block_count() const { return static_cast<std::uint32_t>(blocks_.size()); }

 private:
  struct Block {
    std::array<std::uint64_t, 3> cut{};  // by axis: bit i is the edge at lattice vertex 64 b + i
    std::uint32_t first = 0;             // cut edges in all blocks before
  };
  std::vector<Block> blocks_;
  std::uint32_t count_ = 0;
};

}  // namespace isoloop
