// Which pieces have label 0: all that follows from the spanning forest before any generator.
#pragma once

#include "core/base/bit_set.h"
#include "core/complex/grid_complex.h"

namespace isoloop {

/// `forest`, and all pieces whose label is 0 if those of the forest are. Numbers below
/// complex.piece_bound() that are no piece are in the set too. The outcome does not depend on the
/// order in which edges are read, so in a grid rings of four plain faces, nearly all, are read 64
/// at a time.
BitSet zero_labels(const GridComplex& complex, const BitSet& forest);

}  // namespace isoloop
