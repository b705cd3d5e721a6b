// One side of M within the grid, as the complex that the engines read.
#pragma once

#include <cstdint>
#include <vector>

#include "core/complex.h"
#include "core/edge_index.h"
#include "core/geodesic_size.h"
#include "core/sides.h"

namespace isoloop {

/// Cells and pieces of one side. Numbers (see Lattice): a face's first piece has the face's number,
/// its second piece (the part at the later corner, where M separates two) comes after all faces; a
/// cube's first cell has the cube's number, further cells come after all cubes. On the outside one
/// more cell, last, is all that lies beyond the box. An interior edge, full or cut, has the number
/// of its grid edge.
class GridComplex {
 public:
  /// Keeps references: all three must outlive it.
  GridComplex(const Sides& sides, const EdgeIndex& edges, const EdgeSizes& sizes, Side side);

  std::uint32_t piece_bound() const;
  std::uint32_t cell_bound() const;
  std::uint32_t edge_bound() const { return 3 * sides_.lattice.vertex_count(); }

  std::vector<std::uint32_t> pieces() const;
  std::vector<std::uint32_t> edges() const;
  float size(std::uint32_t piece) const;
  float edge_size(std::uint32_t edge) const;  // of an interior edge, or of its half on this side
  std::array<std::uint32_t, 2> cells(std::uint32_t piece) const;
  ShortList<std::uint32_t, 4> edges_of(std::uint32_t piece) const;
  ShortList<std::uint32_t, 4> ring(std::uint32_t edge) const;

  /// The four pieces round the half of a cut edge on this side, in cyclic order, and the lowest
  /// corners of the cubes between them: cube i lies between pieces i and i + 1.
  struct CutRing {
    std::array<std::uint32_t, 4> pieces;
    std::array<std::uint32_t, 4> cubes;
  };
  CutRing cut_ring(std::uint32_t edge) const;

  /// The segments of M on the piece's border, as pairs of vertices of M.
  ShortList<std::array<std::uint32_t, 2>, 2> segments(std::uint32_t piece) const;

  /// The grid vertices at the piece's corners on this side.
  ShortList<std::uint32_t, 4> corners(std::uint32_t piece) const;

  Side side() const { return side_; }

 private:
  struct Piece {
    std::uint32_t face;
    unsigned ring;     // bit i: corner i of the face's ring belongs to the piece
    unsigned on_side;  // bit i: corner i lies on this side
  };

  bool on_border(std::uint32_t vertex) const;
  std::array<std::uint32_t, 4> face_corners(std::uint32_t face) const;
  std::array<std::uint32_t, 4> face_edges(std::uint32_t face) const;
  unsigned corners_on_side(std::uint32_t face) const;
  bool is_split(std::uint32_t face, unsigned on_side) const;
  Piece describe(std::uint32_t piece) const;
  std::uint32_t piece_at(std::uint32_t face, std::uint32_t corner) const;
  std::uint32_t cell_at(std::uint32_t cube, std::uint32_t corner) const;

  const Sides& sides_;
  const EdgeIndex& edges_;
  const EdgeSizes& sizes_;
  Side side_;
  std::vector<std::uint32_t> split_faces_;       // with two pieces here; ascending
  std::vector<std::uint32_t> many_celled_;       // cubes with more than one cell here; ascending
  std::vector<std::uint32_t> first_extra_cell_;  // of each of them, after all cubes
  std::uint32_t extra_cells_ = 0;
};

static_assert(Complex<GridComplex>);

}  // namespace isoloop
