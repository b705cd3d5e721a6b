// Makes the loops of one side, as a whole, as short as a bounded search can.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/loops/certificate.h"
#include "core/loops/loops.h"
#include "core/surface/surface.h"
#include "core/z2/z2_basis.h"

namespace isoloop {

struct BasisEffort {
  /// Paths that the searches for one side's loops may settle: so many, and so many more for each
  /// vertex of M. A search that has begun is brought to its end.
  double settled = 3e5;
  double settled_per_vertex = 10.0;
  double longest = std::numeric_limits<double>::infinity();  // loop looked for; unit of the spacing
};

/// All g loops of one kind, certified, and border_classes() of the side on which they bound.
struct SideLoops {
  std::span<const Loop> loops;
  const Z2Basis& border_classes;
};

struct ShortenedBasis {
  std::vector<Loop> loops;    // as many as before, in their order
  double least_length = 0.0;  // no basis along edges of M is shorter in all; unit of the spacing
};

/// Exchanges the loops of `side` for shorter ones that together still span what bounds there.
/// Candidates are closed walks through vertices of the loops `across`, the other kind's, for every
/// cycle of this kind crosses one of those an odd number of times; and, about loops that were
/// exchanged, through their own vertices. The shortest are taken while they are independent, until
/// nothing gets shorter or the effort is spent. Each loop keeps its id and size: the cycle that
/// takes its place closes the same handle (or tunnel) and maybe others, that is, its class has
/// coordinate id - 1 in border_classes. Their classes are filled in, but not proved anew (Erickson
/// and Whittlesey, SODA 2005, made to fit a subspace: docs/shortest_loops.md has the proofs and
/// says when the outcome is a minimum).
ShortenedBasis shorten_basis(const Surface& surface, const SurfaceClasses& classes,
                             const SideLoops& side, const SideLoops& across,
                             const BasisEffort& effort = {});

}  // namespace isoloop
