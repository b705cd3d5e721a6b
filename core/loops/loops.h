// Handle and tunnel loops: one for each class of H1(M) that dies in I or in O.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/complex/near_surface.h"
#include "core/curves/curve.h"
#include "core/curves/geodesic.h"
#include "core/engines/dual_pass.h"
#include "core/loops/certificate.h"
#include "core/loops/killing_border.h"
#include "core/surface/surface.h"
#include "core/z2/z2_basis.h"
#include "isoloop/loop.h"

namespace isoloop {

/// The side of M from which classes are seen (split_class) so that the own part of those of a kind
/// vanishes: the side on which they bound, and either where the sides are not told apart.
constexpr Side side_of(LoopKind kind) {
  return kind == LoopKind::tunnel ? Side::outside : Side::inside;
}

/// The kind of the loops that pieces on a side kill.
constexpr LoopKind kind_on(Boundary boundary, Side side) {
  if (boundary == Boundary::open) return LoopKind::loop;
  return side == Side::inside ? LoopKind::handle : LoopKind::tunnel;
}

/// A loop with its measures; not certified. `size`: unit of the spacing. `curves`: not empty.
Loop measured_loop(const Surface& surface, LoopKind kind, int id, double size,
                   std::vector<Curve> curves);

/// Gives the loop the geodesics that its curves shorten to, and measures it anew.
void set_geodesics(const Surface& surface, Loop& loop, std::vector<Geodesic> geodesics);

/// Of each killing piece, the vertices of M to search from for its loop: those on its border, and
/// those closest to the grid vertices at its corners: closest_to(grid vertex).
template <class C, class ClosestTo>
requires MeetsSurface<C> && HasCorners<C> std::vector<Curve> starts_near(
    const C& complex, std::span<const KillingPiece> killing, const ClosestTo& closest_to) {
  std::vector<Curve> starts;
  for (const auto& [piece, size] : killing) {
    Curve& vertices = starts.emplace_back();
    for (const std::uint32_t corner : complex.corners(piece))
      vertices.push_back(closest_to(corner));
    for (const auto& segment : complex.segments(piece))
      vertices.insert(vertices.end(), segment.begin(), segment.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  return starts;
}

/// The killing pieces of one side, and what the labels that the pass gave span there.
struct KilledOnSide {
  Side side = Side::inside;
  std::span<const KillingPiece> killing;
  std::span<const std::vector<std::uint32_t>> starts;  // of each: starts_near()
  const KillingBorders& borders;
  const Z2Basis& border_classes;
  /// Loops of this length and more are not looked for beyond their pieces; unit of the spacing.
  double shorten_below = std::numeric_limits<double>::infinity();
};

struct SearchedLoops {
  std::vector<Loop> loops;
  std::vector<double> seconds;  // CPU time of the search for each, in their order
};

/// The loops of kind_on(surface.boundary, side) that bound on `side`, one for each killing piece,
/// by size: loop i is born on M, is trivial on this side from killing piece i on and not before.
/// Close to the shortest such loop near the piece; where no single closed curve will do (it takes
/// two on nested tori), the border of the surface that the labels span, each curve tightened.
SearchedLoops loops_of_side(const Surface& surface, const SurfaceClasses& classes,
                            const KilledOnSide& killed);

/// Those of one kind; `loops`: by kind.
std::span<const Loop> loops_of_kind(std::span<const Loop> loops, LoopKind kind);

/// CPU seconds of the slowest hundredth of searches, rounded up to whole ones, that took `seconds`
/// each: what a few loops have of the whole.
double slowest_hundredth(std::vector<double> seconds);

/// Puts the loops of two sides that are not told apart in one order, by size, and numbers them.
std::vector<Loop> merged_by_size(std::vector<Loop> inside, std::vector<Loop> outside);

/// Proves that the loops can be drawn and measured: lengths finite and above 0, centres finite,
/// sizes not negative (they may be infinite). Throws SelfCheckFailed. That their points lie on M is
/// the matter of certified() and straightened().
void check_measures(std::span<const Loop> loops);

/// Proves the loops from scratch: closed, on M, trivial on their own side only, and independent,
/// genus(M) of each kind; those of kind `loop`: independent in H1(M), and as many as its rank.
/// Returns them with their certificates and classes. Throws SelfCheckFailed.
std::vector<Loop> certified(const Surface& surface, const SurfaceClasses& classes,
                            std::vector<Loop> loops);

}  // namespace isoloop
