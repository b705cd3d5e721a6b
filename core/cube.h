// How a cube and its faces are cut by M: the only place that knows.
//
// A face with alternating corners is ambiguous: the sign of the bilinear saddle says whether its
// two inside corners are joined across it (asymptotic decider; Nielson and Hamann, Visualization
// 1991). M cuts the surface of a cube in closed curves, each spanned by one patch; the parts of
// the cube between the patches, its cells, are balls.
//
// Corner c = dx + 2 dy + 4 dz. Edge 4 a + k runs along axis a from the corner offset (k & 1, k >>
// 1) in cross_axes(a). Face 2 a + s has normal a and lies at offset s.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/lattice.h"

namespace isoloop {

inline constexpr int max_cells_per_side = 4;

struct CubeCut {
  std::uint8_t triangle_count = 0;
  std::uint8_t polygon_count = 0;
  std::array<std::uint8_t, 2> cell_count{};                 // by Side
  std::array<std::uint8_t, 8> cell_of_corner{};             // number within the corner's side
  std::array<std::array<std::uint8_t, 3>, 10> triangles{};  // cube edges; normal points to O
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

/// Whether the corners of a face alternate; bit i of `ring_inside` is corner i of its ring.
constexpr bool is_ambiguous(unsigned ring_inside) {
  return ring_inside == 0b0101U || ring_inside == 0b1010U;
}

/// Asymptotic decider for an ambiguous face: the inside corners are joined if the product of their
/// distances from iso is more than that of the outside corners; a tie keeps them apart.
/// `level`: value minus iso at the ring's corners, non-negative inside; finite.
bool inside_is_joined(const std::array<double, 4>& level);

}  // namespace isoloop
