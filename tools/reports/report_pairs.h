// The pairs of the paper's algorithm as a table for scripts.
#pragma once

#include <ostream>

#include "tools/runs/run_result.h"

namespace isoloop {

/// One header line, then one line for each of the 2 × genus edges of M that PAIR pairs with
/// triangles off M, those of the inside first, each side's in the order in which it kills: side
/// ("inside" or "outside"), size (of the killing piece; unit of the spacing; "inf" is infinite),
/// piece (its number), then for the edge's ends a and b the vertex of M and its position in the
/// frame of the input.
void write_pairs(std::ostream& out, const LoopsRun& run);

}  // namespace isoloop
