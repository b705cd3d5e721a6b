// The least total length of a basis of handle loops or tunnel loops: exact, for small surfaces.
#pragma once

#include <cstdint>
#include <map>

#include "core/loops/certificate.h"
#include "core/surface/surface.h"
#include "core/z2/label.h"

namespace isoloop::testing {

/// The least total length of genus(M) cycles along edges of M that bound on `side` and are
/// independent, each of any number of closed curves. `longest`: no shorter than the longest loop of
/// some such basis, unit of the spacing. At most 32 generators a side. docs/shortest_loops.md
/// proves it. Shares no code with the search that it judges: an own Dijkstra's search on the
/// homology cover, with all its sheets and from every vertex.
double least_basis_length(const Surface& surface, const SurfaceClasses& classes, Side side,
                          double longest);

/// The length of the shortest closed walk through `base` of each class, the empty one too, that has
/// one no longer than `longest`.
std::map<GeneratorSet, double> closed_walks(const Surface& surface, const SurfaceClasses& classes,
                                            std::uint32_t base, double longest);

}  // namespace isoloop::testing
