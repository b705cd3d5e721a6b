// A complex written out: for one that is no grid, and for tests.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/compressed_rows.h"
#include "core/complex/complex.h"
#include "core/complex/near_surface.h"

namespace isoloop {

/// A piece by all that it borders on.
struct FlatPiece {
  std::array<std::uint32_t, 2> cells{};
  std::vector<std::uint32_t> edges{};                    // interior ones
  std::vector<std::array<std::uint32_t, 2>> segments{};  // of M, as pairs of its vertices
};

/// Piece i is the i-th of those that it was made of. All belong to one layer, and cells to none: a
/// forest is grown by rounds over all trees alone.
class FlatComplex {
 public:
  /// Cells and edges carry any numbers below the bounds.
  FlatComplex(std::uint32_t cell_bound, std::uint32_t edge_bound,
              std::span<const FlatPiece> pieces);

  std::uint32_t piece_bound() const { return static_cast<std::uint32_t>(cells_.size()); }
  std::uint32_t cell_bound() const { return cell_bound_; }
  std::uint32_t edge_bound() const { return static_cast<std::uint32_t>(rings_.first.size() - 1); }
  std::uint32_t layer_count() const { return 1; }
  std::uint32_t first_cell(std::uint32_t) const { return 0; }

  template <class Visit>
  void for_each_piece(std::uint32_t, const Visit& visit) const {
    for (std::uint32_t piece = 0; piece < piece_bound(); ++piece) visit(piece);
  }

  /// Those with a ring.
  template <class Visit>
  void for_each_edge(std::uint32_t, const Visit& visit) const {
    for (std::uint32_t edge = 0; edge < edge_bound(); ++edge)
      if (!rings_[edge].empty()) visit(edge);
  }

  std::array<std::uint32_t, 2> cells(std::uint32_t piece) const { return cells_[piece]; }

  std::span<const std::uint32_t> edges_of(std::uint32_t piece) const { return borders_[piece]; }

  /// Ascending.
  std::span<const std::uint32_t> ring(std::uint32_t edge) const { return rings_[edge]; }

  std::span<const std::array<std::uint32_t, 2>> segments(std::uint32_t piece) const {
    return {segments_.data() + first_segment_[piece],
            first_segment_[piece + 1] - first_segment_[piece]};
  }

 private:
  std::uint32_t cell_bound_;
  std::vector<std::array<std::uint32_t, 2>> cells_;  // by piece
  CompressedRows borders_;                           // edges, by piece
  CompressedRows rings_;                             // pieces, by edge
  std::vector<std::uint32_t> first_segment_;         // of each piece, and the end
  std::vector<std::array<std::uint32_t, 2>> segments_;
};

/// Sizes by number; unit of the spacing.
struct FlatSizes {
  std::vector<float> by_piece;
  std::vector<float> by_edge{};

  float of_piece(std::uint32_t piece) const { return by_piece[piece]; }
  float of_edge(std::uint32_t edge) const { return by_edge[edge]; }
};

/// The complex with its pieces numbered in their order, without gaps; cells and edges keep theirs.
template <PairComplex C>
FlatComplex flattened(const C& complex) {
  std::vector<FlatPiece> pieces;
  for (const std::uint32_t piece : all_pieces(complex)) {
    const auto edges = complex.edges_of(piece);
    const auto segments = complex.segments(piece);
    pieces.push_back(
        {complex.cells(piece), {edges.begin(), edges.end()}, {segments.begin(), segments.end()}});
  }
  return FlatComplex(complex.cell_bound(), complex.edge_bound(), pieces);
}

static_assert(PairComplex<FlatComplex> && Sizes<FlatSizes>);

}  // namespace isoloop
