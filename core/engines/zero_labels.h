// Which pieces have label 0: all that follows from the spanning forest before any generator.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/bit_set.h"
#include "core/complex/complex.h"
#include "core/complex/grid_complex.h"

namespace isoloop {

/// `known`, pieces with label 0, and all pieces whose label is 0 if theirs are: where every piece
/// but one round an interior edge is known, so is the last. `todo`: the edges from which anything
/// may follow.
template <Complex C>
BitSet closed_by_rings(const C& complex, BitSet known, std::vector<std::uint32_t> todo) {
  while (!todo.empty()) {
    const std::uint32_t edge = todo.back();
    todo.pop_back();
    std::uint32_t last = 0;
    int unknown = 0;
    for (const std::uint32_t piece : complex.ring(edge))
      if (!known[piece]) {
        last = piece;
        ++unknown;
      }
    if (unknown != 1) continue;
    known.insert(last);
    for (const std::uint32_t next : complex.edges_of(last)) todo.push_back(next);
  }
  return known;
}

/// `forest`, and all pieces whose label is 0 if those of the forest are. Numbers below
/// complex.piece_bound() that are no piece are in the set too.
template <Complex C>
BitSet zero_labels(const C& complex, const BitSet& forest) {
  BitSet is_piece(complex.piece_bound());
  for (const std::uint32_t piece : all_pieces(complex)) is_piece.insert(piece);
  BitSet known = forest;
  is_piece.for_each_missing(0, complex.piece_bound(), [&](std::uint32_t p) { known.insert(p); });
  return closed_by_rings(complex, std::move(known), all_edges(complex));
}

/// The same. The outcome does not depend on the order in which edges are read, so in a grid rings
/// of four plain faces, nearly all, are read 64 at a time.
BitSet zero_labels(const GridComplex& complex, const BitSet& forest);

}  // namespace isoloop
