// PAIR: the paper's own way to the pieces that kill classes of M, and the cycles they kill.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/complex/near_surface.h"
#include "core/surface/surface.h"

namespace isoloop {

/// The refinements of Dey, Li, Sun, Cohen-Steiner (SIGGRAPH 2008) that make loops short.
/// First: of the cycles wholly on M that are met while a triangle's border is reduced, take the
/// shortest (and of equal ones the first), not the last. The paper takes the first. In a grid most
/// edges off M lie where nothing is narrow and have nearly equal sizes: which of them comes first
/// is a matter of noise, and so is where the first cycle runs.
/// Second: simplices off M enter by geodesic size, not by number alone.
enum class Refinement { none, first, second, both };

bool takes_shortest_cycle(Refinement refinement);
bool orders_by_size(Refinement refinement);

/// Whether a length is less than another by more than rounding makes of equal ones.
bool is_shorter(double length, double other);

struct PairOptions {
  Refinement refinement = Refinement::both;
};

/// An edge of M that stays unpaired after M, and the piece that kills what it gave birth to.
struct SurfacePair {
  std::array<std::uint32_t, 2> edge{};  // vertices of M, ascending
  Side side = Side::inside;             // of the piece
  std::uint32_t piece = 0;              // the triangle is the last of its fan
  float size = 0.0F;                    // of the piece; unit of the spacing; may be infinite
  std::vector<std::array<std::uint32_t, 2>> cycle;  // killed; edges of M, each once
};

/// One side, and what orders it.
template <PairComplex C, Sizes S>
struct SizedSide {
  const C& complex;
  const S& sizes;
};
template <PairComplex C, Sizes S>
SizedSide(const C&, const S&) -> SizedSide<C, S>;

/// Algorithm 1 of the paper on the 2-skeleton of K: M first, then one side, each side for itself
/// after M. Returns 2 genus(M) pairs, those of the inside first, each side's in the order in which
/// they kill. All edges differ, as in the filtration M, inside, outside; every cycle bounds on its
/// own side. With an open boundary the simplices of both sides enter after M in one order (ties in
/// size and number: inside first), and the pairs, as many as the rank of H1(M), come in that order.
/// The total order off M is by (size, number), or by number without the second
/// refinement. Fan triangles of a piece come one after another and its diagonals are the youngest
/// of its edges: all but the last triangle pair with them, and the last one's border comes to the
/// border of the piece, where the reduction starts. Near-cubic at worst, for all that it skips.
/// Throws SelfCheckFailed unless every class of H1(M) dies, half of them inside where M is closed.
/// Compiled in pair.cpp for the complexes that are listed there.
template <PairComplex C, Sizes S>
std::vector<SurfacePair> pair_simplices(const Surface& surface, const SizedSide<C, S>& inside,
                                        const SizedSide<C, S>& outside,
                                        const PairOptions& options = {});

/// Triangles of K off M on one side: each piece of a face counts as the fan that it is cut into.
template <PairComplex C>
std::uint64_t fan_triangle_count(const C& complex);

}  // namespace isoloop
