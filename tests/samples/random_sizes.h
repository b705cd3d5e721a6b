// Sizes without a surface: what an order may be at the worst.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>

#include "core/complex/complex.h"
#include "core/complex/flat_complex.h"

namespace isoloop::testing {

/// Whole numbers below `levels` for edges, many of them equal where levels are few.
template <Complex C>
FlatSizes random_sizes(const C& complex, std::uint32_t levels, std::mt19937& random) {
  FlatSizes sizes;
  sizes.by_edge.resize(complex.edge_bound());
  sizes.by_piece.resize(complex.piece_bound());
  for (const std::uint32_t edge : all_edges(complex))
    sizes.by_edge[edge] = static_cast<float>(random() % levels);
  for (const std::uint32_t piece : all_pieces(complex))
    for (const std::uint32_t edge : complex.edges_of(piece))
      sizes.by_piece[piece] = std::max(sizes.by_piece[piece], sizes.by_edge[edge]);
  return sizes;
}

}  // namespace isoloop::testing
