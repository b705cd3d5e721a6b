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

  /// Of an interior edge, or of its half on this side.
  float of_edge(std::uint32_t edge) const {
    return complex_.side() == Side::outside && edges_.is_cut(edge)
               ? sizes_.of_outside_half[edges_.vertex_on(edge)]
               : sizes_.by_edge[edge];
  }

 private:
  float of_piece_near_surface(std::uint32_t piece) const;

  const GridComplex& complex_;
  const EdgeIndex& edges_;
  const EdgeSizes& sizes_;
};

static_assert(Sizes<GridSizes>);

}  // namespace isoloop
