// The dual pass (docs/dual_pass.md): which pieces kill the classes of M on one side, and a label
// for every piece.
#pragma once

#include <cstdint>
#include <vector>

#include "core/complex/complex.h"
#include "core/z2/label.h"

namespace isoloop {

/// A piece that kills a class of H1(M): at its size the class becomes a border on this side.
struct KillingPiece {
  std::uint32_t piece = 0;
  float size = 0.0F;  // unit of the spacing; may be infinite
};

/// Generator i of the labels is killing[i]. For every interior edge the labels round it sum to 0,
/// killing[i] alone has label {i}, and the pieces whose label contains i are of no larger size:
/// they form a surface across handle or tunnel i, whose border lies on M.
struct DualPass {
  std::vector<KillingPiece> killing;  // ascending by (size, piece): the order in which they kill
  LabelPool pool;
  SparseLabels labels{0};  // numbers in pool
};

/// Reads the filtration of the complex backwards: Kruskal from the largest piece down, then labels
/// by propagation and elimination of the youngest generator. The pieces found are those that PAIR
/// (Dey, Li, Sun, Cohen-Steiner, SIGGRAPH 2008, algorithm 1) pairs with edges of M under the same
/// total order, by Lefschetz duality of (side, M). Near-linear where labels are short. Compiled in
/// dual_pass.cpp for the complexes that are listed there.
template <Complex C, PieceSizes S>
DualPass dual_pass(const C& complex, const S& sizes);

/// Whether the labels round every interior edge sum to 0 and each killing piece has its own label.
/// Checks what a caller would otherwise have to believe; linear in the labels that are not empty.
template <Complex C>
bool labels_are_consistent(const C& complex, const DualPass& pass);

}  // namespace isoloop
