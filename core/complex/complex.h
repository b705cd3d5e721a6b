// What the engines need to know of one side of M as a complex of balls: cells, the pieces between
// them, the rings of pieces round interior edges, and how large they are. Who needs less asks less.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <ranges>
#include <vector>

namespace isoloop {

/// A few values, one after another.
template <class L, class T>
concept ListOf =
    std::ranges::random_access_range<L> && std::same_as<std::ranges::range_value_t<L>, T>;

/// What orders the pieces. Unit of the spacing; not negative, may be infinite.
template <class S>
concept PieceSizes = requires(const S& sizes, std::uint32_t piece) {
  /// g of the piece: the largest of its edges off M.
  { sizes.of_piece(piece) } -> std::same_as<float>;
};

/// What orders the interior edges as well: PAIR alone asks for that.
template <class S>
concept Sizes = PieceSizes<S> && requires(const S& sizes, std::uint32_t edge) {
  { sizes.of_edge(edge) } -> std::same_as<float>;
};

/// Cells and the pieces between them: what a spanning forest asks. Pieces and cells carry numbers
/// below the bounds; not every number below a bound need be in use.
template <class C>
concept DualGraph = requires(const C& complex, std::uint32_t piece, std::uint32_t layer,
                             void (*visit)(std::uint32_t)) {
  { complex.piece_bound() } -> std::convertible_to<std::uint32_t>;
  { complex.cell_bound() } -> std::convertible_to<std::uint32_t>;
  /// Every piece belongs to one layer. Numbers ascend within a layer and from layer to layer;
  /// layers may be visited from several threads at once.
  { complex.layer_count() } -> std::convertible_to<std::uint32_t>;
  complex.for_each_piece(layer, visit);
  /// The cells from first_cell(layer) to first_cell(layer + 1) touch pieces of that layer and the
  /// next, and of the last layer; cells that belong to no layer come after all others.
  { complex.first_cell(layer) } -> std::convertible_to<std::uint32_t>;
  /// The two cells that the piece parts.
  { complex.cells(piece) } -> std::same_as<std::array<std::uint32_t, 2>>;
};

/// The interior edges too: what the dual pass asks. They belong to layers as pieces do.
template <class C>
concept Complex = DualGraph<C> &&
    requires(const C& complex, std::uint32_t piece, std::uint32_t edge, std::uint32_t layer,
             void (*visit)(std::uint32_t)) {
  { complex.edge_bound() } -> std::convertible_to<std::uint32_t>;
  complex.for_each_edge(layer, visit);
  /// The interior edges on the piece's border.
  { complex.edges_of(piece) } -> ListOf<std::uint32_t>;
  /// The pieces round an interior edge.
  { complex.ring(edge) } -> ListOf<std::uint32_t>;
};

/// Every piece, ascending.
template <DualGraph C>
std::vector<std::uint32_t> all_pieces(const C& complex) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t layer = 0; layer < complex.layer_count(); ++layer)
    complex.for_each_piece(layer, [&](std::uint32_t piece) { all.push_back(piece); });
  return all;
}

/// Every interior edge, ascending.
template <Complex C>
std::vector<std::uint32_t> all_edges(const C& complex) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t layer = 0; layer < complex.layer_count(); ++layer)
    complex.for_each_edge(layer, [&](std::uint32_t edge) { all.push_back(edge); });
  return all;
}

}  // namespace isoloop
