// Thin sets of grid vertices that part a handle, or plug a tunnel, where it is narrow.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/compressed_rows.h"
#include "core/complex/near_surface.h"
#include "core/cube/voxel_sides.h"
#include "core/engines/dual_pass.h"
#include "core/z2/label.h"

namespace isoloop {

/// Which membrane is wanted, and what may be used for it. Vertices, edges: of the lattice.
struct MembraneQuery {
  std::span<const std::uint32_t> crossing;  // generators: walks that cross an odd number are odd
  std::span<const std::uint32_t> edges;     // cut edges along the loop that it spans
  const std::vector<bool>& fixed;           // by vertex: must not be in the set
  const std::vector<bool>& gone;            // by vertex: no longer on this side
};

/// How to look for it.
struct MembraneOptions {
  std::uint32_t reach = 0;     // steps from the loop, each within one cell
  bool is_near = false;        // do not look much farther than that for ways round
  bool clear_islands = false;  // keep off parts of the other side that the loop does not run along
};

/// Finds least sets of grid vertices on one side of M that meet every closed walk there of odd
/// class, in the neighbourhood of a loop.
///
/// A walk steps from grid vertex to cell to grid vertex, crosses pieces on its way, and its class
/// is the sum of their labels. The near part N is all within reach of the loop, but for vertices
/// that would close an odd walk within N. If no closed walk in the rest is odd either, potentials
/// on N and on the rest tell, for each place where the two meet, on which of two sides of the
/// membrane it lies. A least vertex cut between them meets every odd walk: cells cannot be cut. So
/// no two vertices of one cell end up on different sides of it, and no ambiguous face or interior
/// tunnel can join what it parts, whatever the values of its vertices become.
/// Compiled in membrane.cpp and membrane_search.cpp for the complexes that are listed there.
template <HoldsVoxels C>
class MembraneFinder {
 public:
  /// Keeps references: all must outlive it.
  MembraneFinder(const VoxelSides& sides, const C& complex, const DualPass& pass);

  /// There may be several least sets. use() is called with the one nearest to one end of the
  /// network and, unless that returned true, with the one nearest to the other end; each is an
  /// ascending list, and an end without a set that will do is passed over. Returns whether use()
  /// returned true; nothing where there is no membrane within reach. use() may call with_severed(),
  /// but not thin().
  std::optional<bool> thin(const MembraneQuery& query, const MembraneOptions& search,
                           const std::function<bool(const std::vector<std::uint32_t>&)>& use);

  /// The set, and the parts of this side that it cuts off: those beside it of at most `most`
  /// vertices. Where every part is that small the largest stays. Parts with fixed vertices stay.
  /// Ascending.
  std::vector<std::uint32_t> with_severed(const MembraneQuery& query,
                                          const std::vector<std::uint32_t>& set, std::size_t most);

  /// The corners of all odd pieces: the surface that the labels span, to the letter. Ascending,
  /// without those that are gone or fixed.
  std::vector<std::uint32_t> spanned(const MembraneQuery& query);

 private:
  struct Search;
  friend struct Search;

  void mark_odd_pieces(std::span<const std::uint32_t> crossing);
  std::vector<std::uint32_t> part_beside(const MembraneQuery& query, std::uint32_t start,
                                         std::uint32_t first_round, std::size_t most);
  bool is_odd(std::uint32_t piece) const { return is_odd_label_[pass_.labels[piece]]; }
  bool is_on_border(std::uint32_t vertex) const {
    return (sides_.cubes[vertex] & VoxelSides::on_border) != 0;
  }

  const VoxelSides& sides_;
  const C& complex_;
  const DualPass& pass_;
  CompressedRows labels_with_;  // by generator
  CompressedRows pieces_with_;  // by label
  GeneratorSet crossing_;       // that the four below are for
  std::vector<std::uint32_t> odd_labels_;
  std::vector<bool> is_odd_label_;
  std::vector<std::uint32_t> odd_corners_;  // of odd pieces
  std::vector<bool> near_odd_;              // by vertex: among them
  std::vector<std::uint32_t> seen_;         // by vertex: the last search that saw it
  std::uint32_t rounds_ = 0;                // searches so far
  // Node of each vertex and cell in the search at hand; `none` between searches.
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> node_of_vertex_;
  std::vector<std::uint32_t> node_of_cell_;
};

}  // namespace isoloop
