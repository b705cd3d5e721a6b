// A loop on M, what was measured and proved of it, and how far its handle or tunnel extends.
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "isoloop/grid.h"
#include "isoloop/surface.h"

namespace isoloop {

/// How sizes are measured. exact: Dijkstra on M for every pair, the paper's definition to the
/// letter. hierarchy: exact up to five voxels; beyond that on ever coarser clusters of M's
/// vertices, whose straight links cut corners about as much as they zigzag.
enum class GeodesicMode { exact, hierarchy };

/// What K is off M: the cubes of the box one by one, or an octree of them, whose pieces are the
/// larger the farther they are from M (docs/octree.md). automatic: the octree where it has fewer
/// than a fifth of the cells.
enum class ComplexKind { automatic, grid, octree };

/// none: the loops as they were found. basis: exchanged for shorter ones, as a whole. curve: then
/// drawn across M's triangles too, and not only along their edges.
enum class Tighten { none, basis, curve };

/// Vertices of M; each is joined to the next, and the last to the first, by an edge of M.
using Curve = std::vector<std::uint32_t>;

/// On an edge of M, at (1 - at) * edge[0] + at * edge[1]; at a vertex both ends are that vertex.
struct SurfacePoint {
  std::array<std::uint32_t, 2> edge{};
  double at = 0.0;  // 0 to 1
};

/// Each point and the next, the last and the first included, lie in one triangle of M.
using Geodesic = std::vector<SurfacePoint>;

/// A handle loop bounds in I (cut there to remove the handle), a tunnel loop in O (fill there).
/// With an open boundary the sides are not told apart, and every loop is a `loop`.
enum class LoopKind { handle, tunnel, loop };

/// "handle loop", "tunnel loop" or "loop".
std::string name_of(LoopKind kind);

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
  int id = 0;  // 1, 2, ... within its kind, by size
  /// How narrow the handle or tunnel is, about half its girth there: the geodesic size g(t) of the
  /// triangle t that kills the loop. Unit of the spacing; infinite if t joins two components of M.
  double size = 0.0;
  double length = 0.0;                // of all curves, or geodesics; unit of the spacing
  double found_length = 0.0;          // of the loop first found there, before Tighten
  std::uint32_t component = 0;        // of M, of the first curve
  Vec3 center_index{};                // mean of the points, weighted by arc length; voxel indices
  std::vector<Curve> curves;          // along edges of M: what is certified
  std::vector<Geodesic> geodesics{};  // empty, or what the curves shorten to, one by one
  LoopCertificate certificate;
  /// Its class in the homology of the side where it does not bound (of M, if its kind is `loop`),
  /// as the certificate's proof found it: numbers of generators, ascending, within one analysis.
  std::vector<std::uint32_t> generators{};
};

/// The points of each closed curve as it is drawn, in voxel indices: of the geodesics if there are
/// any, else of the curves.
std::vector<std::vector<Vec3>> drawn_curves(const SurfaceMesh& surface, const Loop& loop);

/// What the two fronts sweep that leave a loop to either side at equal speed along M's edges.
/// Lengths are in the unit of the spacing.
struct Feature {
  double area = 0.0;  // swept; unit of the spacing, squared
  /// From one last front to the other. Where these are closer than half the depth, as on a ring,
  /// the normal of the loop. Along the index axes in units of length, of length 1, its largest
  /// component positive: it has no direction. 0 where neither is defined.
  Vec3 axis{};
  /// The way of the fronts' centroids, both sides together: of a tunnel from mouth to mouth (beyond
  /// a mouth fronts widen about one place), of a handle from root to root.
  double depth = 0.0;
  /// The shortest of the loop and the fronts, one each voxel of the way, until the two sides meet:
  /// as on a ring, where fronts are no closed curves from there on.
  double least_girth = 0.0;
  double mean_girth = 0.0;                // of the loop and these fronts
  std::vector<std::uint32_t> vertices{};  // of M, swept; ascending

  /// The diameter of a circle as long as the least girth: how thick a round handle is, how wide a
  /// round tunnel.
  double thickness() const { return least_girth / std::numbers::pi; }
};

}  // namespace isoloop
