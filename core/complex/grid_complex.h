// One side of M within the grid, as the complex that the engines read.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/base/inplace_vector.h"
#include "core/complex/complex.h"
#include "core/complex/near_surface.h"
#include "core/cube/voxel_sides.h"
#include "core/surface/edge_index.h"

namespace isoloop {

/// Up to 64 lattice vertices in a row: what is told of them has bit i for vertex + i, and no bit
/// beyond the row.
struct RowPart {
  std::uint32_t vertex;
  std::array<std::uint32_t, 3> position;  // of that vertex
};

/// Calls visit(part) for the parts of a layer, ascending.
template <class Visit>
void for_each_row_part(const Lattice& lattice, std::uint32_t z, const Visit& visit) {
  for (std::uint32_t y = 0; y < lattice.dims[1]; ++y)
    for (std::uint32_t x = 0; x < lattice.dims[0]; x += 64)
      visit(RowPart{lattice.vertex(x, y, z), {x, y, z}});
}

/// Cells and pieces of one side. Numbers (see Lattice): a face's first piece has the face's number,
/// its second piece (the part at the later corner, where M separates two) comes after all faces;
/// then come the walls, the pieces within cubes across the tori that tunnels leave (CubeWall); a
/// cube's first cell has the cube's number, further cells come after all cubes. One more cell,
/// last, is all that lies beyond the box on this side; M keeps the inside from it unless the
/// boundary is open. An interior edge, full or cut, has the number of its grid edge.
class GridComplex {
 public:
  /// Keeps references: both must outlive it.
  GridComplex(const VoxelSides& sides, const EdgeIndex& edges, Side side);

  std::uint32_t piece_bound() const;
  std::uint32_t cell_bound() const;
  std::uint32_t edge_bound() const { return 3 * sides_.lattice.vertex_count(); }

  std::uint32_t layer_count() const { return sides_.lattice.dims[2] + 1; }
  std::uint32_t first_cell(std::uint32_t layer) const {
    return std::min(layer, sides_.lattice.dims[2]) * sides_.lattice.stride[2];
  }
  template <class Visit>
  void for_each_piece(std::uint32_t layer, const Visit& visit) const;
  template <class Visit>
  void for_each_edge(std::uint32_t layer, const Visit& visit) const;
  /// What begins at the vertices of a part of a row, by axis. Faces: those with a piece on this
  /// side, and of these the whole ones (see is_whole_face()), by normal. Edges: interior ones, by
  /// direction. Plain rings: if the edge is interior, the pieces round it are the first pieces of
  /// all faces that the box has round it.
  using Bits = std::array<std::uint64_t, 3>;
  struct FaceBits {
    Bits any{};
    Bits whole{};
  };
  FaceBits faces_in(const RowPart& part) const;
  Bits edges_in(const RowPart& part) const;
  Bits plain_rings_in(const RowPart& part) const;
  /// Whether the piece is a whole face of the grid: M cuts none of its edges, which are
  /// face_edges().
  bool is_whole_face(std::uint32_t piece) const {
    return piece < edge_bound() && corners_on_side(piece) == 15U;
  }
  std::array<std::uint32_t, 4> face_edges(std::uint32_t face) const;
  std::array<std::uint32_t, 2> cells(std::uint32_t piece) const;
  InplaceVector<std::uint32_t, 4> edges_of(std::uint32_t piece) const;
  InplaceVector<std::uint32_t, 8> ring(std::uint32_t edge) const;  // in cyclic order

  CutRing cut_ring(std::uint32_t edge) const;
  /// The walls round an interior edge, as CutRing has them.
  std::array<std::uint32_t, 4> walls_at(std::uint32_t edge) const;
  std::vector<BeyondWall> beyond_walls() const;
  InplaceVector<std::array<std::uint32_t, 2>, 2> segments(std::uint32_t piece) const;

  InplaceVector<std::uint32_t, 4> corners(std::uint32_t piece) const;
  std::uint32_t piece_at(std::uint32_t face, std::uint32_t corner) const;
  std::uint32_t cell_at(std::uint32_t cube, std::uint32_t corner) const;

  const Lattice& lattice() const { return sides_.lattice; }
  Side side() const { return side_; }

 private:
  struct Piece {
    std::uint32_t face;
    unsigned ring;     // bit i: corner i of the face's ring belongs to the piece
    unsigned on_side;  // bit i: corner i lies on this side
  };

  // The answers where M is near, or the border of the box.
  std::array<std::uint32_t, 2> cells_near_surface(std::uint32_t piece) const;
  InplaceVector<std::uint32_t, 4> edges_near_surface(std::uint32_t piece) const;
  InplaceVector<std::uint32_t, 8> ring_near_surface(std::uint32_t edge) const;

  Bits have_next(const RowPart& part) const;
  std::uint64_t on_side_from(std::uint32_t vertex) const;
  bool on_border(std::uint32_t vertex) const {
    return (sides_.cubes[vertex] & VoxelSides::on_border) != 0;
  }

  struct WallEdge {
    std::uint32_t edge;
    std::uint32_t cube;
    std::uint32_t piece;
  };

  void build_walls();
  bool is_wall(std::uint32_t piece) const { return piece >= first_wall_; }
  const VoxelSides::Tunnel& tunnel_of(std::uint32_t wall) const {
    return sides_.tunnels[walls_[wall - first_wall_]];
  }
  bool has_wall_edge(std::uint32_t vertex) const {
    return !has_wall_edge_.empty() && has_wall_edge_[vertex];
  }
  std::array<std::uint32_t, 4> face_pieces(std::uint32_t edge) const;
  std::array<std::uint32_t, 4> face_corners(std::uint32_t face) const;
  unsigned corners_on_side(std::uint32_t face) const;
  bool is_split(std::uint32_t face, unsigned on_side) const;
  Piece describe(std::uint32_t piece) const;

  const VoxelSides& sides_;
  const EdgeIndex& edges_;
  Side side_;
  std::uint8_t many_cells_;                      // the flag of cubes with more than one cell here
  std::vector<std::uint32_t> split_faces_;       // with two pieces here; ascending
  std::vector<std::uint32_t> many_celled_;       // cubes with more than one cell here; ascending
  std::vector<std::uint32_t> first_extra_cell_;  // of each of them, after all cubes
  std::uint32_t extra_cells_ = 0;
  std::uint32_t first_wall_ = 0;      // piece number
  std::vector<std::uint32_t> walls_;  // numbers in VoxelSides::tunnels, ascending
  std::vector<WallEdge> wall_edges_;  // on the walls' borders; ascending by edge, then cube
  std::vector<bool> has_wall_edge_;   // by lowest vertex of the edge; empty without walls
};

inline std::array<std::uint32_t, 4> GridComplex::face_corners(std::uint32_t face) const {
  const std::uint32_t v = face / 3;
  const auto [b, c] = cross_axes(static_cast<int>(face % 3));
  const std::uint32_t db = sides_.lattice.stride[b];
  const std::uint32_t dc = sides_.lattice.stride[c];
  return {v, v + db, v + db + dc, v + dc};
}

/// Edge i joins corners i and i + 1.
inline std::array<std::uint32_t, 4> GridComplex::face_edges(std::uint32_t face) const {
  const std::uint32_t v = face / 3;
  const auto [b, c] = cross_axes(static_cast<int>(face % 3));
  const auto ub = static_cast<std::uint32_t>(b);
  const auto uc = static_cast<std::uint32_t>(c);
  return {3 * v + ub, 3 * (v + sides_.lattice.stride[b]) + uc,
          3 * (v + sides_.lattice.stride[c]) + ub, 3 * v + uc};
}

inline unsigned GridComplex::corners_on_side(std::uint32_t face) const {
  const auto corners = face_corners(face);
  unsigned bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= unsigned{sides_.inside[corners[i]]} << i;
  return side_ == Side::inside ? bits : ~bits & 15U;
}

/// Calls visit(3 (vertex + i) + a) for each bit i of `bits`[a], ascending.
template <class Visit>
void for_each_number(std::uint32_t vertex, const GridComplex::Bits& bits, const Visit& visit) {
  for (std::uint64_t left = bits[0] | bits[1] | bits[2]; left != 0; left &= left - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(left));
    for (std::uint32_t a = 0; a < 3; ++a)
      if ((bits[a] >> i & 1U) != 0) visit(3 * (vertex + i) + a);
  }
}

template <class Visit>
void GridComplex::for_each_piece(std::uint32_t layer, const Visit& visit) const {
  if (layer == sides_.lattice.dims[2]) {
    for (std::uint32_t piece = edge_bound(); piece < piece_bound(); ++piece) visit(piece);
    return;
  }
  for_each_row_part(lattice(), layer, [&](const RowPart& part) {
    for_each_number(part.vertex, faces_in(part).any, visit);
  });
}

template <class Visit>
void GridComplex::for_each_edge(std::uint32_t layer, const Visit& visit) const {
  if (layer == sides_.lattice.dims[2]) return;
  for_each_row_part(lattice(), layer, [&](const RowPart& part) {
    for_each_number(part.vertex, edges_in(part), visit);
  });
}

inline std::array<std::uint32_t, 2> GridComplex::cells(std::uint32_t piece) const {
  const std::uint32_t v = piece / 3;
  if (piece >= edge_bound() || on_border(v)) return cells_near_surface(piece);
  const std::uint32_t below = v - sides_.lattice.stride[piece % 3];
  if (((sides_.cubes[v] | sides_.cubes[below]) & many_cells_) != 0)
    return cells_near_surface(piece);
  return {below, v};
}

inline InplaceVector<std::uint32_t, 4> GridComplex::edges_of(std::uint32_t piece) const {
  if (!is_whole_face(piece)) return edges_near_surface(piece);
  return {face_edges(piece), 4};
}

inline InplaceVector<std::uint32_t, 8> GridComplex::ring(std::uint32_t edge) const {
  const std::uint32_t v = edge / 3;
  if (on_border(v) || has_wall_edge(v)) return ring_near_surface(edge);
  const auto [b, c] = cross_axes(static_cast<int>(edge % 3));
  const std::uint32_t before_b = v - sides_.lattice.stride[b];
  const std::uint32_t before_c = v - sides_.lattice.stride[c];
  const unsigned flags = sides_.cubes[v] | sides_.cubes[before_b] | sides_.cubes[before_c];
  if ((flags & VoxelSides::has_ambiguous_face) != 0) return ring_near_surface(edge);
  const auto ub = static_cast<std::uint32_t>(b);
  const auto uc = static_cast<std::uint32_t>(c);
  return {{3 * v + uc, 3 * v + ub, 3 * before_b + uc, 3 * before_c + ub}, 4};
}

static_assert(BesideSurface<GridComplex> && MeetsSurface<GridComplex> && HoldsVoxels<GridComplex>);

}  // namespace isoloop
