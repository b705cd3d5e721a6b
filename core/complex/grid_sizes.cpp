#include "core/complex/grid_sizes.h"

namespace isoloop {

float GridSizes::of_piece_near_surface(std::uint32_t piece) const {
  float largest = 0.0F;
  for (const std::uint32_t edge : complex_.edges_of(piece))
    largest = std::max(largest, of_edge(edge));
  return largest;
}

GridComplex::Bits GridSizes::not_zero_in(const RowPart& part,
                                         const GridComplex::Bits& whole) const {
  const auto& stride = complex_.lattice().stride;
  const SparseSizes& of_edges = sizes_.by_edge;
  GridComplex::Bits not_zero{};
  for (std::uint32_t a = 0; a < 3; ++a) {
    if (whole[a] == 0) continue;
    const std::uint32_t b = (a + 1) % 3;
    const std::uint32_t c = (a + 2) % 3;
    not_zero[a] = of_edges.not_zero(b, part.vertex) |
                  of_edges.not_zero(b, part.vertex + stride[c]) |
                  of_edges.not_zero(c, part.vertex) | of_edges.not_zero(c, part.vertex + stride[b]);
  }
  return not_zero;
}

}  // namespace isoloop
