// One side of M within an octree, as the complex that the engines read (docs/octree.md).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/inplace_vector.h"
#include "core/complex/complex.h"
#include "core/complex/grid_complex.h"
#include "core/complex/near_surface.h"
#include "core/octree/octree.h"

namespace isoloop {

/// Cells are the leaves, pieces the minimal faces; where M is near both are those of the grid.
/// Numbers: see Octree. Second pieces, walls, further cells and the cell beyond the box come after
/// all others, as in GridComplex. An interior edge, full or cut, has the number of its minimal
/// edge.
class OctreeComplex {
 public:
  /// Keeps references: both must outlive it. `grid`: the same side of the same volume.
  OctreeComplex(const Octree& octree, const GridComplex& grid) : octree_(octree), grid_(grid) {}

  std::uint32_t piece_bound() const {
    return edge_bound() + grid_.piece_bound() - grid_.edge_bound();
  }
  std::uint32_t cell_bound() const {
    return octree_.vertex_count() + grid_.cell_bound() - octree_.lattice().vertex_count();
  }
  std::uint32_t edge_bound() const { return 3 * octree_.vertex_count(); }

  std::uint32_t layer_count() const { return octree_.layer_count() + 1; }
  std::uint32_t first_cell(std::uint32_t layer) const {
    return octree_.first_vertex(std::min(layer, octree_.layer_count()));
  }
  template <class Visit>
  void for_each_piece(std::uint32_t layer, const Visit& visit) const;
  /// Those of a layer, but not of the last, that lie in its first plane of vertices.
  template <class Visit>
  void for_each_piece_in_first_plane(std::uint32_t layer, const Visit& visit) const;
  template <class Visit>
  void for_each_edge(std::uint32_t layer, const Visit& visit) const;

  std::array<std::uint32_t, 2> cells(std::uint32_t piece) const {
    if (!is_of_grid(piece) && !octree_.is_on_border(piece / 3)) {
      const auto leaves = octree_.leaves_beside(piece / 3, piece % 3);
      if (!octree_.has_many_cells(leaves[0], side()) && !octree_.has_many_cells(leaves[1], side()))
        return leaves;
    }
    return cells_near_surface(piece);
  }
  InplaceVector<std::uint32_t, 8> edges_of(std::uint32_t piece) const;
  InplaceVector<std::uint32_t, 8> ring(std::uint32_t edge) const;  // in cyclic order

  /// Of a cut edge of the grid.
  CutRing cut_ring(std::uint32_t grid_edge) const;
  std::vector<BeyondWall> beyond_walls() const;
  InplaceVector<std::array<std::uint32_t, 2>, 2> segments(std::uint32_t piece) const;
  /// Grid vertices; see HasCorners.
  InplaceVector<std::uint32_t, 4> corners(std::uint32_t piece) const;

  /// Whether M cuts the piece's face or the piece lies within a cube: what the grid tells of it.
  bool is_of_grid(std::uint32_t piece) const {
    return piece >= edge_bound() || octree_.is_face_cut(piece / 3, piece % 3);
  }
  /// The edge of the grid that a cut edge is.
  std::uint32_t grid_edge(std::uint32_t edge) const {
    return 3 * octree_.lattice_vertex(edge / 3) + edge % 3;
  }

  const Octree& octree() const { return octree_; }
  Side side() const { return grid_.side(); }

 private:
  std::array<std::uint32_t, 2> cells_near_surface(std::uint32_t piece) const;  // or the border

  bool is_here(std::uint32_t vertex) const {
    return octree_.is_inside(vertex) == (side() == Side::inside);
  }
  std::uint32_t grid_piece(std::uint32_t piece) const {
    return piece < edge_bound() ? grid_edge(piece) : piece - edge_bound() + grid_.edge_bound();
  }
  /// Numbers of the grid's pieces (and edges) and cells as they are here. no_piece stays.
  std::uint32_t piece_of(std::uint32_t grid_piece) const;
  std::uint32_t cell_of(std::uint32_t grid_cell) const;
  std::array<std::uint32_t, 4> faces_round(std::uint32_t edge) const;

  const Octree& octree_;
  const GridComplex& grid_;
};

template <class Visit>
void OctreeComplex::for_each_piece(std::uint32_t layer, const Visit& visit) const {
  if (layer == octree_.layer_count()) {
    for (std::uint32_t piece = edge_bound(); piece < piece_bound(); ++piece) visit(piece);
    return;
  }
  for (std::uint32_t v = octree_.first_vertex(layer); v < octree_.first_vertex(layer + 1); ++v)
    for (std::uint32_t a = 0; a < 3; ++a)
      if (octree_.face_height(v, a) != Octree::none && (is_here(v) || octree_.is_face_cut(v, a)))
        visit(3 * v + a);
}

template <class Visit>
void OctreeComplex::for_each_piece_in_first_plane(std::uint32_t layer, const Visit& visit) const {
  constexpr std::uint32_t across = 2;
  for (std::uint32_t v = octree_.first_vertex(layer); v < octree_.end_of_first_plane(layer); ++v)
    if (octree_.face_height(v, across) != Octree::none &&
        (is_here(v) || octree_.is_face_cut(v, across)))
      visit(3 * v + across);
}

template <class Visit>
void OctreeComplex::for_each_edge(std::uint32_t layer, const Visit& visit) const {
  if (layer == octree_.layer_count()) return;
  for (std::uint32_t v = octree_.first_vertex(layer); v < octree_.first_vertex(layer + 1); ++v)
    for (std::uint32_t a = 0; a < 3; ++a)
      if (octree_.edge_height(v, a) != Octree::none && (is_here(v) || octree_.is_edge_cut(v, a)))
        visit(3 * v + a);
}

static_assert(BesideSurface<OctreeComplex> && MeetsSurface<OctreeComplex> &&
              HasCorners<OctreeComplex>);

}  // namespace isoloop
