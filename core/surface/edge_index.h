// Finds the vertex of M on a cut grid edge in constant time and half a byte a grid vertex, and four
// bytes a vertex of M.
#pragma once

#include <cstdint>
#include <vector>

#include "core/cube/voxel_sides.h"
#include "core/surface/edge_set.h"

namespace isoloop {

/// Numbers M's vertices by their cut edges: bricks of the lattice one after another along Morton's
/// curve, so that neighbours on M lie close in memory; within a brick in scan order. Hence of two
/// vertices in one row of the lattice the one with the lesser x comes first.
class EdgeIndex {
 public:
  explicit EdgeIndex(const VoxelSides& sides);

  std::uint32_t count() const { return cut_.count(); }

  bool is_cut(std::uint32_t grid_edge) const { return cut_[grid_edge]; }

  /// Bit i: whether the edge along `axis` at lattice vertex `first` + i is cut.
  std::uint64_t cut_bits(std::uint32_t axis, std::uint32_t first) const {
    return cut_.bits(axis, first);
  }

  /// `grid_edge` must be cut.
  std::uint32_t vertex_on(std::uint32_t grid_edge) const { return number_[cut_.rank(grid_edge)]; }

  /// Calls visit(vertex of M, grid edge) for the cut edges at lattice vertices 64 b .. 64 b + 63.
  template <class Visit>
  void visit_block(std::uint32_t b, const Visit& visit) const {
    cut_.visit_block(
        b, [&](std::uint32_t rank, std::uint32_t grid_edge) { visit(number_[rank], grid_edge); });
  }

  std::uint32_t block_count() const { return cut_.block_count(); }

 private:
  EdgeSet cut_;
  std::vector<std::uint32_t> number_;  // of M's vertices, by the rank of the cut edge
};

}  // namespace isoloop
