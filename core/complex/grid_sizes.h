// The sizes of one side's pieces and edges within the grid.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/complex/complex.h"
#include "core/complex/grid_complex.h"
#include "core/sizes/geodesic_size.h"
#include "core/surface/edge_index.h"

namespace isoloop {

/// Reads them off the sizes of grid edges. Keeps references: all three must outlive it.
class GridSizes {
 public:
  GridSizes(const GridComplex& complex, const EdgeIndex& edges, const EdgeSizes& sizes)
      : complex_(complex), edges_(edges), sizes_(sizes) {}

  float of_piece(std::uint32_t piece) const {
    if (!complex_.is_whole_face(piece)) return of_piece_near_surface(piece);
    float largest = 0.0F;
    for (const std::uint32_t edge : complex_.face_edges(piece))
      largest = std::max(largest, sizes_.by_edge[edge]);
    return largest;
  }

  /// Calls visit(piece, its size) for the pieces of a layer, ascending.
  template <class Visit>
  void for_each_piece(std::uint32_t layer, const Visit& visit) const;

  /// Of an interior edge, or of its half on this side.
  float of_edge(std::uint32_t edge) const {
    return complex_.side() == Side::outside && edges_.is_cut(edge)
               ? sizes_.of_outside_half[edges_.vertex_on(edge)]
               : sizes_.by_edge[edge];
  }

 private:
  float of_piece_near_surface(std::uint32_t piece) const;

  /// Of the whole faces that begin at the part, those whose size may not be 0.
  GridComplex::Bits not_zero_in(const RowPart& part, const GridComplex::Bits& whole) const;

  const GridComplex& complex_;
  const EdgeIndex& edges_;
  const EdgeSizes& sizes_;
};

template <class Visit>
void GridSizes::for_each_piece(std::uint32_t layer, const Visit& visit) const {
  if (layer == complex_.lattice().dims[2]) {
    complex_.for_each_piece(layer, [&](std::uint32_t piece) { visit(piece, of_piece(piece)); });
    return;
  }
  for_each_row_part(complex_.lattice(), layer, [&](const RowPart& part) {
    const GridComplex::FaceBits faces = complex_.faces_in(part);
    const GridComplex::Bits not_zero = not_zero_in(part, faces.whole);
    for_each_number(part.vertex, faces.any, [&](std::uint32_t piece) {
      const std::uint32_t i = piece / 3 - part.vertex;
      const bool is_zero =
          (faces.whole[piece % 3] >> i & 1U) != 0 && (not_zero[piece % 3] >> i & 1U) == 0;
      visit(piece, is_zero ? 0.0F : of_piece(piece));
    });
  });
}

/// The same where 64 sizes of 0 are told at a time.
template <class Visit>
void for_each_sized(const GridComplex&, const GridSizes& sizes, std::uint32_t layer,
                    const Visit& visit) {
  sizes.for_each_piece(layer, visit);
}

static_assert(Sizes<GridSizes>);

}  // namespace isoloop
