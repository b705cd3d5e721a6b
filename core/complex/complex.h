// What the engines need to know of a complex: cells, the pieces between them, and the rings of
// pieces round interior edges. The grid models it, and a tetrahedral mesh can.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <vector>

#include "core/base/short_list.h"

namespace isoloop {

/// One side of M as a complex of balls. Pieces, cells and edges carry numbers below the bounds;
/// not every number below a bound need be in use.
template <class C>
concept Complex = requires(const C& complex, std::uint32_t piece, std::uint32_t edge,
                           std::uint32_t layer, void (*visit)(std::uint32_t)) {
  { complex.piece_bound() } -> std::convertible_to<std::uint32_t>;
  { complex.cell_bound() } -> std::convertible_to<std::uint32_t>;
  { complex.edge_bound() } -> std::convertible_to<std::uint32_t>;
  /// Every piece, ascending; every interior edge, ascending.
  { complex.pieces() } -> std::same_as<std::vector<std::uint32_t>>;
  { complex.edges() } -> std::same_as<std::vector<std::uint32_t>>;
  /// Every piece and every interior edge belongs to one layer. Numbers ascend within a layer and
  /// from layer to layer; layers may be visited from several threads at once.
  { complex.layer_count() } -> std::convertible_to<std::uint32_t>;
  /// The cells from first_cell(layer) to first_cell(layer + 1) touch pieces of that layer and the
  /// next, and of the last layer; cells that belong to no layer come after all others.
  { complex.first_cell(layer) } -> std::convertible_to<std::uint32_t>;
  complex.for_each_piece(layer, visit);
  complex.for_each_edge(layer, visit);
  /// g of the piece: the largest of its edges off M.
  { complex.size(piece) } -> std::same_as<float>;
  /// The two cells that the piece parts.
  { complex.cells(piece) } -> std::same_as<std::array<std::uint32_t, 2>>;
  /// The interior edges on the piece's border.
  { complex.edges_of(piece).begin() } -> std::convertible_to<const std::uint32_t*>;
  /// The pieces round an interior edge.
  { complex.ring(edge).begin() } -> std::convertible_to<const std::uint32_t*>;
};

}  // namespace isoloop
