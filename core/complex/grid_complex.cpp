#include "core/complex/grid_complex.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <tuple>

#include <tbb/parallel_for.h>

#include "core/surface/surface.h"

namespace isoloop {
namespace {

std::uint32_t position_in(const std::vector<std::uint32_t>& sorted, std::uint32_t value) {
  return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), value) -
                                    sorted.begin());
}

/// Whether face number `face` has its far corner within the box.
bool face_exists(const Lattice& lattice, const std::array<std::uint32_t, 3>& p, int axis) {
  const auto [b, c] = cross_axes(axis);
  return p[b] + 1 < lattice.dims[b] && p[c] + 1 < lattice.dims[c];
}

/// The cubes round an edge, by lowest corner, in the order of GridComplex::face_pieces().
std::array<std::uint32_t, 4> cubes_round(const Lattice& lattice, std::uint32_t edge) {
  const std::uint32_t v = edge / 3;
  const auto [b, c] = cross_axes(static_cast<int>(edge % 3));
  const std::uint32_t db = lattice.stride[b];
  const std::uint32_t dc = lattice.stride[c];
  return {v, v - db, v - db - dc, v - dc};
}

/// Bit i: whether `bit` of number first + i is set; of 64 numbers, as far as there are some.
std::uint64_t flags_from(const std::vector<std::uint8_t>& numbers, std::size_t first,
                         unsigned bit) {
  constexpr std::uint64_t each = 0x0101010101010101;
  constexpr std::uint64_t gather =
      0x0102040810204080;  // the lowest bit of each byte in the highest
  std::uint64_t flags = 0;
  if (first + 64 <= numbers.size() && std::endian::native == std::endian::little) {
    for (unsigned i = 0; i < 64; i += 8) {
      std::uint64_t eight = 0;
      std::memcpy(&eight, numbers.data() + first + i, sizeof eight);
      flags |= ((eight >> bit & each) * gather >> 56) << i;
    }
  } else {
    for (std::size_t i = first; i < std::min(first + 64, numbers.size()); ++i)
      flags |= std::uint64_t{numbers[i] >> bit & 1U} << (i - first);
  }
  return flags;
}

/// Collects, in ascending order, what visit(vertex, position, sink) emits for every vertex.
template <class Visit>
std::vector<std::uint32_t> gather(const Lattice& lattice, const Visit& visit) {
  std::vector<std::vector<std::uint32_t>> layers(lattice.dims[2]);
  tbb::parallel_for(std::uint32_t{0}, lattice.dims[2], [&](std::uint32_t z) {
    std::uint32_t v = lattice.vertex(0, 0, z);
    for (std::uint32_t y = 0; y < lattice.dims[1]; ++y)
      for (std::uint32_t x = 0; x < lattice.dims[0]; ++x, ++v)
        visit(v, std::array<std::uint32_t, 3>{x, y, z}, layers[z]);
  });
  std::size_t total = 0;
  for (const auto& layer : layers) total += layer.size();
  std::vector<std::uint32_t> all;
  all.reserve(total);
  for (auto& layer : layers) {
    all.insert(all.end(), layer.begin(), layer.end());
    layer = std::vector<std::uint32_t>();
  }
  return all;
}

}  // namespace

GridComplex::GridComplex(const VoxelSides& sides, const EdgeIndex& edges, Side side)
    : sides_(sides),
      edges_(edges),
      side_(side),
      many_cells_(side == Side::inside ? VoxelSides::many_inside_cells
                                       : VoxelSides::many_outside_cells) {
  const Lattice& lattice = sides.lattice;
  split_faces_ = gather(lattice, [&](std::uint32_t v, const auto& p, auto& found) {
    for (int a = 0; a < 3; ++a) {
      const std::uint32_t face = 3 * v + static_cast<std::uint32_t>(a);
      if ((sides.cubes[v] & VoxelSides::has_ambiguous_face) != 0 && face_exists(lattice, p, a) &&
          is_split(face, corners_on_side(face)))
        found.push_back(face);
    }
  });
  many_celled_ = gather(lattice, [&](std::uint32_t v, const auto&, auto& found) {
    if ((sides.cubes[v] & many_cells_) != 0) found.push_back(v);
  });
  for (const std::uint32_t cube : many_celled_) {
    first_extra_cell_.push_back(extra_cells_);
    extra_cells_ += cut_at(sides, cube).cell_count[static_cast<int>(side)] - 1U;
  }
  build_walls();
}

void GridComplex::build_walls() {
  first_wall_ = edge_bound() + static_cast<std::uint32_t>(split_faces_.size());
  for (std::uint32_t t = 0; t < sides_.tunnels.size(); ++t) {
    const VoxelSides::Tunnel& tunnel = sides_.tunnels[t];
    if (joined_side(sides_, tunnel) == side_) continue;
    for (const std::uint8_t edge : cut_at(sides_, tunnel).wall.edges)
      wall_edges_.push_back({lattice_edge(sides_.lattice, tunnel.cube, edge), tunnel.cube,
                             first_wall_ + static_cast<std::uint32_t>(walls_.size())});
    walls_.push_back(t);
  }
  if (walls_.empty()) return;
  std::sort(wall_edges_.begin(), wall_edges_.end(), [](const WallEdge& a, const WallEdge& b) {
    return std::tie(a.edge, a.cube) < std::tie(b.edge, b.cube);
  });
  has_wall_edge_.resize(sides_.lattice.vertex_count());
  for (const WallEdge& on_wall : wall_edges_) has_wall_edge_[on_wall.edge / 3] = true;
}

/// Those that have a neighbour after them along each axis.
GridComplex::Bits GridComplex::have_next(const RowPart& part) const {
  const auto& [nx, ny, nz] = lattice().dims;
  const auto first = [](std::uint32_t count) {
    return count < 64 ? (std::uint64_t{1} << count) - 1 : ~std::uint64_t{0};
  };
  const auto& [x, y, z] = part.position;
  const std::uint64_t in_row = first(nx - x);
  return {first(nx - 1 - x), y + 1 < ny ? in_row : 0, z + 1 < nz ? in_row : 0};
}

std::uint64_t GridComplex::on_side_from(std::uint32_t vertex) const {
  const std::uint64_t inside = flags_from(sides_.inside, vertex, 0);
  return side_ == Side::inside ? inside : ~inside;
}

GridComplex::FaceBits GridComplex::faces_in(const RowPart& part) const {
  const Bits next = have_next(part);
  const std::uint64_t here = on_side_from(part.vertex);
  Bits along{};  // the neighbours along each axis
  for (std::size_t a = 0; a < 3; ++a)
    if (next[a] != 0) along[a] = on_side_from(part.vertex + lattice().stride[a]);
  FaceBits faces;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const std::size_t c = (a + 2) % 3;
    const std::uint64_t there = next[b] & next[c];
    if (there == 0) continue;
    const std::uint64_t across =
        on_side_from(part.vertex + lattice().stride[b] + lattice().stride[c]);
    faces.any[a] = there & (here | along[b] | along[c] | across);
    faces.whole[a] = there & here & along[b] & along[c] & across;
  }
  return faces;
}

GridComplex::Bits GridComplex::edges_in(const RowPart& part) const {
  Bits edges = have_next(part);
  const std::uint64_t here = on_side_from(part.vertex);
  for (std::size_t a = 0; a < 3; ++a)
    if (edges[a] != 0) edges[a] &= here | on_side_from(part.vertex + lattice().stride[a]);
  return edges;
}

GridComplex::Bits GridComplex::plain_rings_in(const RowPart& part) const {
  const auto ambiguous_from = [&](std::uint32_t vertex) {
    return flags_from(sides_.cubes, vertex,
                      std::countr_zero(unsigned{VoxelSides::has_ambiguous_face}));
  };
  const std::uint64_t here = ambiguous_from(part.vertex);
  std::uint64_t plain = ~here;
  if (!has_wall_edge_.empty())
    for (std::uint32_t i = 0; i < 64 && part.position[0] + i < lattice().dims[0]; ++i)
      if (has_wall_edge_[part.vertex + i]) plain &= ~(std::uint64_t{1} << i);
  Bits before{here << 1, 0, 0};  // the neighbours before them along each axis
  for (std::size_t a = 0; a < 3; ++a)
    if (part.position[a] > 0) before[a] = ambiguous_from(part.vertex - lattice().stride[a]);
  return {plain & ~(before[1] | before[2]), plain & ~(before[2] | before[0]),
          plain & ~(before[0] | before[1])};
}

std::uint32_t GridComplex::piece_bound() const {
  return first_wall_ + static_cast<std::uint32_t>(walls_.size());
}

std::uint32_t GridComplex::cell_bound() const {
  return sides_.lattice.vertex_count() + extra_cells_ + 1;
}

bool GridComplex::is_split(std::uint32_t face, unsigned on_side) const {
  if (!is_ambiguous(on_side)) return false;
  const bool joined = (sides_.cubes[face / 3] >> (face % 3) & VoxelSides::lower_face_joined) != 0;
  return joined != (side_ == Side::inside);
}

GridComplex::Piece GridComplex::describe(std::uint32_t piece) const {
  const bool second = piece >= edge_bound();
  const std::uint32_t face = second ? split_faces_[piece - edge_bound()] : piece;
  const unsigned on_side = corners_on_side(face);
  if (!is_split(face, on_side)) return {face, on_side, on_side};
  const unsigned lowest = on_side & (~on_side + 1U);
  return {face, second ? on_side ^ lowest : lowest, on_side};
}

std::uint32_t GridComplex::piece_at(std::uint32_t face, std::uint32_t corner) const {
  if ((sides_.cubes[face / 3] & VoxelSides::has_ambiguous_face) == 0) return face;
  const unsigned on_side = corners_on_side(face);
  if (!is_split(face, on_side)) return face;
  const auto corners = face_corners(face);
  const unsigned at = 1U << (std::find(corners.begin(), corners.end(), corner) - corners.begin());
  if ((on_side & (~on_side + 1U)) == at) return face;
  return edge_bound() + position_in(split_faces_, face);
}

std::uint32_t GridComplex::cell_at(std::uint32_t cube, std::uint32_t corner) const {
  if ((sides_.cubes[cube] & many_cells_) == 0) return cube;
  unsigned c = 0;
  std::uint32_t rest = corner - cube;
  for (int a = 2; a >= 0; --a)
    if (rest >= sides_.lattice.stride[a]) {
      rest -= sides_.lattice.stride[a];
      c |= 1U << a;
    }
  const unsigned number = cut_at(sides_, cube).cell_of_corner[c];
  if (number == 0) return cube;
  return sides_.lattice.vertex_count() + first_extra_cell_[position_in(many_celled_, cube)] +
         number - 1;
}

std::array<std::uint32_t, 2> GridComplex::cells_near_surface(std::uint32_t piece) const {
  if (is_wall(piece)) {
    const std::uint32_t cell = cell_at(tunnel_of(piece).cube, corners(piece)[0]);
    return {cell, cell};
  }
  const Piece p = describe(piece);
  const auto face_corner = face_corners(p.face);
  unsigned i = 0;
  while ((p.ring >> i & 1U) == 0) ++i;
  const std::uint32_t v = p.face / 3;
  const std::uint32_t axis = p.face % 3;
  const std::uint32_t below = v - sides_.lattice.stride[axis];
  if (!on_border(v)) return {cell_at(below, face_corner[i]), cell_at(v, face_corner[i])};
  const std::uint32_t beyond = cell_bound() - 1;
  const std::uint32_t at = sides_.lattice.position(v)[axis];
  return {at == 0 ? beyond : cell_at(below, face_corner[i]),
          at + 1 == sides_.lattice.dims[axis] ? beyond : cell_at(v, face_corner[i])};
}

InplaceVector<std::uint32_t, 4> GridComplex::edges_near_surface(std::uint32_t piece) const {
  InplaceVector<std::uint32_t, 4> list;
  if (is_wall(piece)) {
    const VoxelSides::Tunnel& tunnel = tunnel_of(piece);
    for (const std::uint8_t edge : cut_at(sides_, tunnel).wall.edges)
      list.push_back(lattice_edge(sides_.lattice, tunnel.cube, edge));
    return list;
  }
  const Piece p = describe(piece);
  const auto around = face_edges(p.face);
  for (unsigned i = 0; i < 4; ++i)
    if ((p.ring >> i & 1U) != 0 || (p.ring >> ((i + 1) & 3U) & 1U) != 0) list.push_back(around[i]);
  return list;
}

std::array<std::uint32_t, 4> GridComplex::face_pieces(std::uint32_t edge) const {
  const std::uint32_t v = edge / 3;
  const int a = static_cast<int>(edge % 3);
  const auto [b, c] = cross_axes(a);
  const Lattice& lattice = sides_.lattice;
  const std::uint32_t corner = sides_.is_on(side_, v) ? v : v + lattice.stride[a];
  const auto ub = static_cast<std::uint32_t>(b);
  const auto uc = static_cast<std::uint32_t>(c);
  std::array<bool, 4> there{true, true, true, true};
  if (on_border(v)) {
    const auto p = lattice.position(v);
    there = {p[b] + 1 < lattice.dims[b], p[c] + 1 < lattice.dims[c], p[b] > 0, p[c] > 0};
  }
  return {there[0] ? piece_at(3 * v + uc, corner) : no_piece,
          there[1] ? piece_at(3 * v + ub, corner) : no_piece,
          there[2] ? piece_at(3 * (v - lattice.stride[b]) + uc, corner) : no_piece,
          there[3] ? piece_at(3 * (v - lattice.stride[c]) + ub, corner) : no_piece};
}

std::array<std::uint32_t, 4> GridComplex::walls_at(std::uint32_t edge) const {
  std::array<std::uint32_t, 4> walls{no_piece, no_piece, no_piece, no_piece};
  if (has_wall_edge_.empty() || !has_wall_edge_[edge / 3]) return walls;
  const auto cubes = cubes_round(sides_.lattice, edge);
  auto at = std::lower_bound(
      wall_edges_.begin(), wall_edges_.end(), edge,
      [](const WallEdge& on_wall, std::uint32_t wanted) { return on_wall.edge < wanted; });
  for (; at != wall_edges_.end() && at->edge == edge; ++at)
    walls[static_cast<std::size_t>(std::find(cubes.begin(), cubes.end(), at->cube) -
                                   cubes.begin())] = at->piece;
  return walls;
}

InplaceVector<std::uint32_t, 8> GridComplex::ring_near_surface(std::uint32_t edge) const {
  const auto pieces = face_pieces(edge);
  const auto walls = walls_at(edge);
  InplaceVector<std::uint32_t, 8> list;
  for (std::size_t i = 0; i < 4; ++i) {
    if (pieces[i] != no_piece) list.push_back(pieces[i]);
    if (walls[i] != no_piece) list.push_back(walls[i]);
  }
  return list;
}

CutRing GridComplex::cut_ring(std::uint32_t edge) const {
  return {face_pieces(edge), cubes_round(sides_.lattice, edge), walls_at(edge)};
}

std::vector<BeyondWall> GridComplex::beyond_walls() const {
  std::vector<BeyondWall> all;
  for (std::uint32_t piece = first_wall_; piece < piece_bound(); ++piece) {
    const VoxelSides::Tunnel& tunnel = tunnel_of(piece);
    for (const CubeWall::TriangleCorner& at : cut_at(sides_, tunnel).wall.beyond)
      all.push_back({piece, tunnel.cube, at.triangle, at.corner});
  }
  return all;
}

InplaceVector<std::array<std::uint32_t, 2>, 2> GridComplex::segments(std::uint32_t piece) const {
  InplaceVector<std::array<std::uint32_t, 2>, 2> list;
  if (is_wall(piece)) {
    const VoxelSides::Tunnel& tunnel = tunnel_of(piece);
    const auto& [from, middle, to] = cut_at(sides_, tunnel).wall.on_m;
    const std::uint32_t on_ring =
        ring_vertex(edges_, walls_[piece - first_wall_], middle - first_ring_vertex);
    for (const std::uint8_t end : {from, to})
      list.push_back({edges_.vertex_on(lattice_edge(sides_.lattice, tunnel.cube, end)), on_ring});
    return list;
  }
  const Piece p = describe(piece);
  const unsigned inside = side_ == Side::inside ? p.on_side : ~p.on_side & 15U;
  const bool joined =
      (sides_.cubes[p.face / 3] >> (p.face % 3) & VoxelSides::lower_face_joined) != 0;
  const FaceCut cut = face_cut(inside, joined);
  const auto around = face_edges(p.face);
  for (int s = 0; s < cut.segment_count; ++s) {
    const auto [from, to] = cut.segments[s];
    // The end of a cut edge on this side: the corner that the segment's piece holds.
    const unsigned corner = (p.on_side >> from & 1U) != 0 ? from : (from + 1U) & 3U;
    if ((p.ring >> corner & 1U) != 0)
      list.push_back({edges_.vertex_on(around[from]), edges_.vertex_on(around[to])});
  }
  return list;
}

InplaceVector<std::uint32_t, 4> GridComplex::corners(std::uint32_t piece) const {
  InplaceVector<std::uint32_t, 4> list;
  if (is_wall(piece)) {
    const VoxelSides::Tunnel& tunnel = tunnel_of(piece);
    for (const std::uint8_t corner : cut_at(sides_, tunnel).wall.corners)
      list.push_back(sides_.lattice.corner(tunnel.cube, static_cast<unsigned>(corner)));
    return list;
  }
  const Piece p = describe(piece);
  const auto corners = face_corners(p.face);
  for (unsigned i = 0; i < 4; ++i)
    if ((p.ring >> i & 1U) != 0) list.push_back(corners[i]);
  return list;
}

}  // namespace isoloop
