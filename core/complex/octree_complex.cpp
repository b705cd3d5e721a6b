#include "core/complex/octree_complex.h"

namespace isoloop {

static_assert(Octree::no_vertex == no_piece);  // of faces that are asked for in vain

std::uint32_t OctreeComplex::piece_of(std::uint32_t grid_piece) const {
  if (grid_piece == no_piece) return no_piece;
  if (grid_piece >= grid_.edge_bound()) return grid_piece - grid_.edge_bound() + edge_bound();
  return 3 * octree_.vertex_at(grid_piece / 3) + grid_piece % 3;
}

std::uint32_t OctreeComplex::cell_of(std::uint32_t grid_cell) const {
  const std::uint32_t cubes = octree_.lattice().vertex_count();
  return grid_cell < cubes ? octree_.leaf_at(grid_cell)
                           : grid_cell - cubes + octree_.vertex_count();
}

std::array<std::uint32_t, 2> OctreeComplex::cells_near_surface(std::uint32_t piece) const {
  const std::uint32_t height =
      piece < edge_bound() ? octree_.face_height(piece / 3, piece % 3) : 0U;
  if (height == 0) {
    const auto [below, above] = grid_.cells(grid_piece(piece));
    return {cell_of(below), cell_of(above)};
  }
  const std::uint32_t v = piece / 3;
  const std::uint32_t axis = piece % 3;
  const std::uint32_t at = octree_.lattice_vertex(v);
  const Lattice& lattice = octree_.lattice();
  const auto position = lattice.position(at);
  const std::uint32_t beyond = cell_bound() - 1;
  return {position[axis] == 0 ? beyond : octree_.leaf_at(at - lattice.stride[axis], height),
          position[axis] + 1 == lattice.dims[axis] ? beyond : octree_.leaf_at(at, height)};
}

InplaceVector<std::uint32_t, 8> OctreeComplex::edges_of(std::uint32_t piece) const {
  InplaceVector<std::uint32_t, 8> list;
  if (is_of_grid(piece)) {
    for (const std::uint32_t edge : grid_.edges_of(grid_piece(piece)))
      list.push_back(piece_of(edge));
    return list;
  }
  octree_.for_each_side(piece / 3, piece % 3, [&](std::uint32_t v, std::uint32_t a, bool is_one) {
    list.push_back(3 * v + a);
    if (!is_one) list.push_back(3 * octree_.end_of(v, a, octree_.edge_height(v, a)) + a);
  });
  return list;
}

/// Of an edge that M does not cut, in the order of CutRing. A face has the edge's height, and then
/// begins or ends where the edge does, or one more.
std::array<std::uint32_t, 4> OctreeComplex::faces_round(std::uint32_t edge) const {
  const std::uint32_t v = edge / 3;
  const std::uint32_t axis = edge % 3;
  const std::uint32_t height = octree_.edge_height(v, axis);
  const std::uint32_t at = octree_.lattice_vertex(v);
  const Lattice& lattice = octree_.lattice();
  const auto position = lattice.position(at);
  std::array<bool, 3> along{};
  along[axis] = true;
  const std::uint32_t wide_at = octree_.rounded(position, height + 1, along);
  const std::array<std::uint32_t, 2> across{(axis + 1) % 3, (axis + 2) % 3};
  std::array<std::uint32_t, 4> faces{no_piece, no_piece, no_piece, no_piece};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::uint32_t b = across[i];
    const std::uint32_t normal = across[1 - i];
    const auto find = [&](std::uint32_t first, std::uint32_t face_height) {
      return octree_.face_at(first, normal, face_height);
    };
    std::uint32_t& after = faces[i];
    std::uint32_t& before = faces[i + 2];
    after = find(at, height);
    if (after == no_piece) after = find(wide_at, height + 1);
    if (position[b] >= 1U << height) before = find(at - octree_.step(height, b), height);
    if (before == no_piece && position[b] >= 2U << height)
      before = find(wide_at - octree_.step(height + 1, b), height + 1);
  }
  return faces;
}

InplaceVector<std::uint32_t, 8> OctreeComplex::ring(std::uint32_t edge) const {
  InplaceVector<std::uint32_t, 8> list;
  const bool is_cut = octree_.is_edge_cut(edge / 3, edge % 3);
  const auto faces = is_cut ? cut_ring(grid_edge(edge)).pieces : faces_round(edge);
  const auto walls = octree_.edge_height(edge / 3, edge % 3) == 0
                         ? grid_.walls_at(grid_edge(edge))
                         : std::array{no_piece, no_piece, no_piece, no_piece};
  for (std::size_t i = 0; i < 4; ++i) {
    if (faces[i] != no_piece) list.push_back(faces[i]);
    if (walls[i] != no_piece) list.push_back(piece_of(walls[i]));
  }
  return list;
}

CutRing OctreeComplex::cut_ring(std::uint32_t grid_edge) const {
  CutRing ring = grid_.cut_ring(grid_edge);
  for (std::size_t i = 0; i < 4; ++i) {
    ring.pieces[i] = piece_of(ring.pieces[i]);
    ring.walls[i] = piece_of(ring.walls[i]);
  }
  return ring;
}

std::vector<BeyondWall> OctreeComplex::beyond_walls() const {
  std::vector<BeyondWall> all = grid_.beyond_walls();
  for (BeyondWall& beyond : all) beyond.piece = piece_of(beyond.piece);
  return all;
}

InplaceVector<std::array<std::uint32_t, 2>, 2> OctreeComplex::segments(std::uint32_t piece) const {
  if (!is_of_grid(piece)) return {};
  return grid_.segments(grid_piece(piece));
}

InplaceVector<std::uint32_t, 4> OctreeComplex::corners(std::uint32_t piece) const {
  if (is_of_grid(piece)) return grid_.corners(grid_piece(piece));
  const std::uint32_t at = octree_.lattice_vertex(piece / 3);
  const std::uint32_t height = octree_.face_height(piece / 3, piece % 3);
  const std::uint32_t b = octree_.step(height, (piece + 1) % 3);
  const std::uint32_t c = octree_.step(height, (piece + 2) % 3);
  return {{at, at + b, at + b + c, at + c}, 4};
}

}  // namespace isoloop
