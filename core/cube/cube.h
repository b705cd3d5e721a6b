// How a cube and its faces are cut by M: the only place that knows.
//
// A face with alternating corners is ambiguous: the sign of the bilinear saddle says whether its
// two inside corners are joined across it (asymptotic decider; Nielson and Hamann, Visualization
// 1991). M cuts the surface of a cube in closed curves, each spanned by one patch, a disc; the
// parts of the cube between the patches, its cells, are balls.
//
// Where the interpolant has an interior tunnel (core/cube/cube_interior.h), two of the discs give
// way to an annulus, the tube, which joins two cells of one side into one. A ball with a tube
// through it is a solid torus: a wall, a disc across it that leads from the tube to the cube's
// surface, cuts the other side's cell to a ball. Both sides of the wall are one cell.
//
// The wall's border runs from the one curve along the tube to the other, and back over the cube's
// surface, on the torus' side, along cube edges. Cut along the wall, the torus' border becomes: the
// share of the cube's surface with a slit, the annulus with a slit, the wall twice, and discs. That
// is a sphere: the torus, of Euler characteristic 0, cut along a curve that does not part it (it
// crosses the tube once), with two discs put in. And a sphere in space bounds a ball (Alexander).
// Such a wall exists: pushed along it, the tube, which is not knotted, comes to lie in the cube's
// surface. How often the tube's triangles wind round it does not matter: a turn of the solid tube,
// from 0 at one end to a full one at the other, unwinds them and moves nothing else. The two cells
// that the tube joins become one ball: two balls and a solid tube between a disc of each.
//
// Corner c = dx + 2 dy + 4 dz. Edge 4 a + k runs along axis a from the corner offset (k & 1, k >>
// 1) in cross_axes(a). Face 2 a + s has normal a and lies at offset s.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/inplace_vector.h"
#include "core/grid/lattice.h"

namespace isoloop {

inline constexpr int max_cells_per_side = 4;

/// Vertices of a patch: the cube edge that carries it, or from first_ring_vertex on the ring round
/// a tunnel.
inline constexpr int first_ring_vertex = 12;
inline constexpr int ring_size = 3;

struct CubeCut {
  std::uint8_t triangle_count = 0;
  std::uint8_t disc_count = 0;                   // patches but the annulus
  std::array<std::uint8_t, 2> cell_count{};      // by Side
  std::array<std::uint8_t, 8> cell_of_corner{};  // number within the corner's side
  /// Corners where a tunnel may begin, in cuts without one. A tunnel joins the cell at its hub to
  /// the cell of the same side towards the opposite corner.
  InplaceVector<std::uint8_t, 2> hubs;
  std::array<std::array<std::uint8_t, 3>, 16> triangles{};  // vertices; normal points to O
};

/// The disc that cuts the solid torus round a tunnel to a ball.
struct CubeWall {
  InplaceVector<std::uint8_t, 4>
      edges;  // cube edges that carry its border off M, from curve to curve
  InplaceVector<std::uint8_t, 3> corners;  // of the cube, between them
  std::array<std::uint8_t, 3> on_m{};  // vertices of its border on M: on a curve, the ring, a curve
  struct TriangleCorner {
    std::uint8_t triangle;  // of the cut
    std::uint8_t corner;
  };
  /// Where the triangles that meet at a vertex of on_m lie beyond the wall. On the curves: in the
  /// sense of rotation from axis b to c of cross_axes() about the cube edge. On the ring: beyond
  /// either of its two sectors.
  std::vector<TriangleCorner> beyond;
};

/// A cube with a tunnel. The vertex first_ring_vertex + a of the ring round it sits at that corner
/// of the box between the roots (tunnel_roots()) which is the hub's neighbour along axis a.
struct TunnelCut {
  CubeCut cut;
  CubeWall wall;
};

/// The corners of a face in ring order, counter-clockwise seen from outside the cube.
std::span<const std::uint8_t, 4> face_ring(int face);

/// Where M crosses a face, walked counter-clockwise seen from outside the cube: from where the walk
/// enters I to where it leaves, so that the normal of M points to O. Face edge i joins the ring
/// corners i and i + 1.
struct FaceCut {
  std::uint8_t segment_count = 0;                         // 0, 1, or 2 on an ambiguous face
  std::array<std::array<std::uint8_t, 2>, 2> segments{};  // directed as on the patch in the cube
};

/// `ring_inside`: bit i is corner i of the face's ring.
FaceCut face_cut(unsigned ring_inside, bool joined);

/// Lower and upper corner of a cube edge.
std::array<int, 2> edge_corners(int cube_edge);

/// `inside`: bit c set if corner c is inside. `joined`: bit f set if the inside corners of face f
/// are joined (read only where f is ambiguous). `odd`: parity of the cube's x + y + z in the grid.
/// Parity steers the diagonals of patches, so that paths on M do not favour one direction.
const CubeCut& cube_cut(std::uint8_t inside, std::uint8_t joined, bool odd);

/// The same with a tunnel. `hub` must be one of those of cube_cut().
const TunnelCut& tunnel_cut(std::uint8_t inside, std::uint8_t joined, bool odd, int hub);

/// Whether the corners of a face alternate; bit i of `ring_inside` is corner i of its ring.
constexpr bool is_ambiguous(unsigned ring_inside) {
  return ring_inside == 0b0101U || ring_inside == 0b1010U;
}

/// Asymptotic decider for an ambiguous face: the inside corners are joined if the product of their
/// distances from iso is more than that of the outside corners, exactly; a tie keeps them apart.
/// `level`: value minus iso at the ring's corners, non-negative inside; finite.
bool inside_is_joined(const std::array<double, 4>& level);

}  // namespace isoloop
