// Handle and tunnel loops: one for each class of H1(M) that dies in I or in O.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/complex/grid_complex.h"
#include "core/curves/geodesic.h"
#include "core/engines/dual_pass.h"
#include "core/grid/grid.h"
#include "core/loops/certificate.h"
#include "core/loops/killing_border.h"
#include "core/surface/surface.h"
#include "core/z2/z2_basis.h"

namespace isoloop {

/// A handle loop bounds in I (cut there to remove the handle), a tunnel loop in O (fill there).
/// With an open boundary the sides are not told apart, and every loop is a `loop`.
enum class LoopKind { handle, tunnel, loop };

/// "handle loop", "tunnel loop" or "loop".
std::string name_of(LoopKind kind);

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

/// What was proved of a loop: that its class in H1(M) is not 0 and independent of those of the
/// other loops; and, unless its kind is `loop`, whether it vanishes in H1(I) and in H1(O).
struct LoopCertificate {
  bool nontrivial_on_surface = false;
  bool trivial_inside = false;
  bool trivial_outside = false;
};

/// A cycle on M, maybe of several closed curves.
struct Loop {
  LoopKind kind = LoopKind::handle;
  int id = 0;                 // 1, 2, ... within its kind, by size
  double size = 0.0;          // g(t), unit of the spacing; infinite if t joins two components of M
  double length = 0.0;        // of all curves, or geodesics; unit of the spacing
  double found_length = 0.0;  // of the loop that was found near the killing piece
  std::uint32_t component = 0;        // of M, of the first curve
  Vec3 center_index{};                // mean of the points, weighted by arc length; voxel indices
  std::vector<Curve> curves;          // along edges of M: what is certified
  std::vector<Geodesic> geodesics{};  // empty, or what the curves shorten to, one by one
  LoopCertificate certificate;
};

/// A loop with its measures; not certified. `size`: unit of the spacing. `curves`: not empty.
Loop measured_loop(const Surface& surface, LoopKind kind, int id, double size,
                   std::vector<Curve> curves);

/// Gives the loop the geodesics that its curves shorten to, and measures it anew.
void set_geodesics(const Surface& surface, Loop& loop, std::vector<Geodesic> geodesics);

/// The points of each closed curve as it is drawn, in voxel indices: of the geodesics if there are
/// any, else of the curves.
std::vector<std::vector<Vec3>> drawn_curves(const Surface& surface, const Loop& loop);

/// One side of M as far as the passes have brought it.
struct SolvedSide {
  const GridComplex& complex;
  const DualPass& pass;
  const KillingBorders& borders;
  const Z2Basis& border_classes;
};

/// The loops of kind_on(surface.boundary, side) that bound on `side`, one for each killing piece,
/// by size: loop i is born on M, is trivial on this side from killing piece i on and not before.
/// `closest`: by lattice vertex. Close to the shortest such loop near the piece; where no single
/// closed curve will do (it takes two on nested tori), the border of the surface that the labels
/// span, each curve tightened.
std::vector<Loop> loops_of_side(const Surface& surface, const SurfaceClasses& classes,
                                const SolvedSide& side, std::span<const std::uint32_t> closest);

/// Puts the loops of two sides that are not told apart in one order, by size, and numbers them.
std::vector<Loop> merged_by_size(std::vector<Loop> inside, std::vector<Loop> outside);

/// Proves that the loops can be drawn and measured: lengths finite and above 0, centres finite,
/// sizes not negative (they may be infinite). Throws SelfCheckFailed. That their points lie on M is
/// the matter of certify() and straighten_loops().
void check_measures(std::span<const Loop> loops);

/// Proves the loops from scratch: closed, on M, trivial on their own side only, and independent,
/// genus(M) of each kind; those of kind `loop`: independent in H1(M), and as many as its rank.
/// Fills in the certificates. Throws SelfCheckFailed.
void certify(const Surface& surface, const SurfaceClasses& classes, std::vector<Loop>& loops);

}  // namespace isoloop
