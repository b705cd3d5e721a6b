#include "tests/oracles/explicit_complex.h"

#include <algorithm>
#include <bitset>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>

#include "tests/oracles/swept_cube.h"

namespace isoloop::oracle {
namespace {

using Place = ExplicitComplex::Place;
using Position = std::array<int, 3>;
using CornerSet = std::bitset<8>;  // of a cube

/// Groups the parts of a cube's faces (at most three a face) or its segments into classes.
class Classes {
 public:
  Classes() { std::iota(root_.begin(), root_.end(), 0); }
  int of(int i) const { return root_[i]; }
  void merge(int a, int b) { std::replace(root_.begin(), root_.end(), root_[a], root_[b]); }

 private:
  std::array<int, 18> root_{};
};

bool holds(const Chain& chain, int cell) {
  return std::binary_search(chain.begin(), chain.end(), cell);
}

Chain ends_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// One square face: its corners in ring order and what M makes of it.
struct CutFace {
  struct Part {
    bool inside = false;
    std::array<bool, 4> has{};  // by position in the ring
    int face = 0;               // number in the complex

    auto corner_count() const { return std::count(has.begin(), has.end(), true); }
  };
  std::array<Position, 4> ring;
  std::vector<Part> parts;
  std::vector<int> segments;  // edge numbers
};

class Builder {
 public:
  Builder(const std::vector<double>& inside_value, const Index3& dims, const Lattice& box,
          const std::optional<Walls>& walls)
      : value_(inside_value),
        dims_(dims),
        box_(box),
        walls_(walls),
        grid_vertices_(box.vertex_count(), -1),
        crossings_(3 * std::size_t{box.vertex_count()}, -1),
        edge_ends_(6 * std::size_t{box.vertex_count()}, -1),
        faces_(3 * std::size_t{box.vertex_count()}) {
    for_each_position([&](const Position& p) { inside_.push_back(value(p) >= 0); });
  }

  ExplicitComplex build() {
    for_each_position([&](const Position& p) {
      for (int axis = 0; axis < 3; ++axis)
        if (fits(p, {axis})) add_grid_edge(p, axis);
    });
    for_each_position([&](const Position& p) {
      for (int axis = 0; axis < 3; ++axis)
        if (fits(p, {(axis + 1) % 3, (axis + 2) % 3})) cut_face(p, axis);
    });
    for_each_position([&](const Position& p) {
      if (fits(p, {0, 1, 2})) cut_cube(p);
    });
    if (walls_ && walls_built_ != walls_->size()) throw std::logic_error("a wall lacks its tunnel");
    return std::move(complex_);
  }

 private:
  template <class Visit>
  void for_each_position(const Visit& visit) const {
    for (int z = 0; z < static_cast<int>(box_.dims[2]); ++z)
      for (int y = 0; y < static_cast<int>(box_.dims[1]); ++y)
        for (int x = 0; x < static_cast<int>(box_.dims[0]); ++x) visit(Position{x, y, z});
  }

  bool fits(const Position& p, std::initializer_list<int> axes) const {
    return std::all_of(axes.begin(), axes.end(),
                       [&](int a) { return p[a] + 1 < static_cast<int>(box_.dims[a]); });
  }

  static Position step(Position p, int axis) {
    ++p[axis];
    return p;
  }

  double value(const Position& p) const {
    std::int64_t index = 0;
    for (int a = 2; a >= 0; --a) {
      const std::int64_t i = p[a] + box_.first[a];
      if (i < 0 || i >= dims_[a]) return -std::numeric_limits<double>::infinity();
      index = index * dims_[a] + i;
    }
    return value_[static_cast<std::size_t>(index)];
  }
  bool inside(const Position& p) const { return inside_[number(p, 0) / 3]; }
  Place place(const Position& p) const { return inside(p) ? Place::inside : Place::outside; }

  int grid_vertex(const Position& p) {
    int& vertex = grid_vertices_[number(p, 0) / 3];
    if (vertex < 0) {
      vertex = static_cast<int>(complex_.vertices.size());
      complex_.vertices.push_back(place(p));
    }
    return vertex;
  }

  /// Of the grid edge or face with lowest corner p, as Lattice has it.
  std::size_t number(const Position& p, int axis) const {
    return 3 * std::size_t{box_.vertex(static_cast<std::uint32_t>(p[0]),
                                       static_cast<std::uint32_t>(p[1]),
                                       static_cast<std::uint32_t>(p[2]))} +
           static_cast<std::size_t>(axis);
  }
  int& edge_end(std::size_t grid_edge, bool is_inside) {
    return edge_ends_[2 * grid_edge + (is_inside ? 1 : 0)];
  }

  void add_edge(std::size_t grid_edge, const Position& p, int from, int to) {
    edge_end(grid_edge, inside(p)) = static_cast<int>(complex_.edges.size());
    complex_.edges.push_back({place(p), ends_of(from, to)});
    complex_.grid_edge_of_edge.push_back(static_cast<std::uint32_t>(grid_edge));
  }

  void add_grid_edge(const Position& p, int axis) {
    const Position q = step(p, axis);
    const std::size_t edge = number(p, axis);
    const int from = grid_vertex(p);
    const int to = grid_vertex(q);
    if (inside(p) == inside(q)) {
      add_edge(edge, p, from, to);
      return;
    }
    crossings_[edge] = static_cast<int>(complex_.vertices.size());
    complex_.vertices.push_back(Place::on_m);
    add_edge(edge, p, from, crossings_[edge]);
    add_edge(edge, q, to, crossings_[edge]);
  }

  /// Number of the edge between two neighbours.
  std::size_t edge_between(const Position& p, const Position& q) const {
    int axis = 0;
    while (p[axis] == q[axis]) ++axis;
    return number(std::min(p, q), axis);
  }

  /// Of an ambiguous face: whether the bilinear interpolant's saddle is inside.
  bool saddle_is_inside(const std::array<Position, 4>& ring) const {
    const double a = value(ring[0]), b = value(ring[1]), c = value(ring[2]), d = value(ring[3]);
    return (a * c - b * d) / (a + c - b - d) > 0;
  }

  void cut_face(const Position& p, int axis) {
    const int b = (axis + 1) % 3;
    const int c = (axis + 2) % 3;
    CutFace face;
    face.ring = {p, step(p, b), step(step(p, b), c), step(p, c)};
    const auto& ring = face.ring;
    Classes parts;
    int changes = 0;
    for (int i = 0; i < 4; ++i) {
      if (inside(ring[i]) == inside(ring[(i + 1) % 4]))
        parts.merge(i, (i + 1) % 4);
      else
        ++changes;
    }
    if (changes == 4) {
      const int joined = inside(ring[0]) == saddle_is_inside(ring) ? 0 : 1;
      parts.merge(joined, joined + 2);
    }
    for (int root = 0; root < 4; ++root) {
      CutFace::Part part;
      part.inside = inside(ring[root]);
      for (int i = 0; i < 4; ++i) part.has[i] = parts.of(i) == root;
      if (part.corner_count() > 0) face.parts.push_back(part);
    }
    add_segments(face);
    for (CutFace::Part& part : face.parts) add_part(face, part);
    faces_[number(p, axis)] = std::move(face);
  }

  /// Where M cuts the stretches of the ring that a part takes up.
  Chain crossings_of(const CutFace& face, const CutFace::Part& part) const {
    Chain crossings;
    for (int i = 0; i < 4; ++i)
      if (part.has[i] != part.has[(i + 1) % 4])
        crossings.push_back(crossings_[edge_between(face.ring[i], face.ring[(i + 1) % 4])]);
    return crossings;
  }

  /// M leaves a part along one segment for each stretch of the ring that the part leaves out.
  void add_segments(CutFace& face) {
    // Parts of fewer corners are convex: one segment each, across the two cut edges that bound
    // their stretch of the ring. With two parts of two corners, one segment serves both.
    const std::size_t wanted = face.parts.size() - 1;
    std::sort(face.parts.begin(), face.parts.end(),
              [](const auto& l, const auto& r) { return l.corner_count() < r.corner_count(); });
    for (std::size_t i = 0; i < wanted; ++i) {
      const Chain ends = crossings_of(face, face.parts[i]);
      face.segments.push_back(static_cast<int>(complex_.edges.size()));
      complex_.edges.push_back({Place::on_m, ends_of(ends[0], ends[1])});
    }
  }

  void add_part(const CutFace& face, CutFace::Part& part) {
    Chain border;
    border.reserve(6);
    for (int i = 0; i < 4; ++i)
      if (part.has[i] || part.has[(i + 1) % 4])
        border.push_back(edge_end(edge_between(face.ring[i], face.ring[(i + 1) % 4]), part.inside));
    Chain crossings = crossings_of(face, part);
    std::sort(crossings.begin(), crossings.end());
    for (const int segment : face.segments) {
      const Chain& ends = complex_.edges[segment].boundary;
      if (std::includes(crossings.begin(), crossings.end(), ends.begin(), ends.end()))
        border.push_back(segment);
    }
    std::sort(border.begin(), border.end());
    part.face = static_cast<int>(complex_.faces.size());
    complex_.faces.push_back({part.inside ? Place::inside : Place::outside, std::move(border)});
  }

  void cut_cube(const Position& p) {
    std::vector<const CutFace*> sides;
    for (int axis = 0; axis < 3; ++axis) {
      sides.push_back(&faces_[number(p, axis)]);
      sides.push_back(&faces_[number(step(p, axis), axis)]);
    }
    // Parts of the cube's surface that share a corner belong to one cell.
    std::vector<const CutFace::Part*> parts;
    std::vector<CornerSet> corners;
    for (const CutFace* face : sides)
      for (const CutFace::Part& part : face->parts) {
        parts.push_back(&part);
        corners.push_back(corners_of(*face, part, p));
      }
    Classes cells;
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if ((corners[i] & corners[k]).any()) cells.merge(static_cast<int>(i), static_cast<int>(k));
    const std::optional<bool> torus = walls_ ? join_within(p, parts, corners, cells) : std::nullopt;
    const Curves curves = trace_curves(sides);
    const std::vector<int> patches = add_patches(curves, parts, cells);
    if (torus) add_wall(static_cast<std::uint32_t>(number(p, 0) / 3), *torus, curves);
    for (int root = 0; root < static_cast<int>(parts.size()); ++root) {
      ExplicitComplex::Cell cell{parts[root]->inside ? Place::inside : Place::outside, {}};
      for (int i = 0; i < static_cast<int>(parts.size()); ++i)
        if (cells.of(i) == root) cell.boundary.push_back(parts[i]->face);
      if (cell.boundary.empty()) continue;
      add_patches_of(cell, patches);
      std::sort(cell.boundary.begin(), cell.boundary.end());
      complex_.solids.push_back(cell);
    }
  }

  /// Joins the cells that the interpolant joins within the cube. If it does: whether the torus
  /// round the tunnel is inside.
  std::optional<bool> join_within(const Position& p, const std::vector<const CutFace::Part*>& parts,
                                  const std::vector<CornerSet>& corners, Classes& cells) const {
    std::array<double, 8> values{};
    for (int c = 0; c < 8; ++c)
      values[c] = std::max(-1e3, value({p[0] + (c & 1), p[1] + (c >> 1 & 1), p[2] + (c >> 2 & 1)}));
    const SweptCube swept = sweep(values);
    const auto swept_part = [&](int i) {
      std::size_t c = 0;
      while (!corners[i][c]) ++c;
      return swept.part_of_corner[c];
    };
    bool joined = false;
    for (int i = 0; i < static_cast<int>(parts.size()); ++i)
      for (int k = 0; k < i; ++k) {
        if (cells.of(i) == cells.of(k) || swept_part(i) != swept_part(k)) continue;
        cells.merge(i, k);
        joined = true;
      }
    if (joined != (swept.cycles[0] + swept.cycles[1] == 1))
      throw std::logic_error("a tunnel must join two cells and go through one");
    if (!joined) return std::nullopt;
    return swept.cycles[1] == 1;
  }

  /// Of the cube whose lowest corner is p.
  static CornerSet corners_of(const CutFace& face, const CutFace::Part& part, const Position& p) {
    CornerSet corners;
    for (int i = 0; i < 4; ++i) {
      const Position& c = face.ring[i];
      if (part.has[i]) corners.set((c[0] - p[0]) + 2 * (c[1] - p[1]) + 4 * (c[2] - p[2]));
    }
    return corners;
  }

  /// The parts of faces leave the cell open along M's segments; patches close it there.
  void add_patches_of(ExplicitComplex::Cell& cell, const std::vector<int>& patches) const {
    const Chain parts = cell.boundary;
    for (const int patch : patches) {
      const int segment = complex_.faces[patch].boundary.front();
      if (std::any_of(parts.begin(), parts.end(),
                      [&](int part) { return holds(complex_.faces[part].boundary, segment); }))
        cell.boundary.push_back(patch);
    }
  }

  /// The segments on a cube's faces, strung into closed curves.
  struct Curves {
    std::vector<int> segments;
    Classes classes;  // of places in `segments`
  };

  Curves trace_curves(const std::vector<const CutFace*>& sides) const {
    Curves curves;
    std::vector<int>& segments = curves.segments;
    for (const CutFace* face : sides)
      segments.insert(segments.end(), face->segments.begin(), face->segments.end());
    for (std::size_t i = 0; i < segments.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const Chain& a = complex_.edges[segments[i]].boundary;
        const Chain& b = complex_.edges[segments[k]].boundary;
        if (std::any_of(a.begin(), a.end(), [&](int v) { return holds(b, v); }))
          curves.classes.merge(static_cast<int>(i), static_cast<int>(k));
      }
    return curves;
  }

  /// One patch for all curves between the same two cells: a tube is bounded by two of them, and,
  /// cut open along the wall's edges on M, is a disc.
  std::vector<int> add_patches(Curves curves, const std::vector<const CutFace::Part*>& parts,
                               const Classes& cells) {
    const auto count = static_cast<int>(curves.segments.size());
    const auto cells_at = [&](int segment) {
      std::set<int> found;
      for (int i = 0; i < static_cast<int>(parts.size()); ++i)
        if (holds(complex_.faces[parts[i]->face].boundary, curves.segments[segment]))
          found.insert(cells.of(i));
      return found;
    };
    for (int i = 0; walls_ && i < count; ++i)
      for (int k = 0; k < i; ++k)
        if (curves.classes.of(i) != curves.classes.of(k) && cells_at(i) == cells_at(k))
          curves.classes.merge(i, k);
    std::vector<int> patches;
    for (int root = 0; root < count; ++root) {
      ExplicitComplex::Cell patch{Place::on_m, {}};
      for (int i = 0; i < count; ++i)
        if (curves.classes.of(i) == root) patch.boundary.push_back(curves.segments[i]);
      if (patch.boundary.empty()) continue;
      std::sort(patch.boundary.begin(), patch.boundary.end());
      patches.push_back(static_cast<int>(complex_.faces.size()));
      complex_.faces.push_back(patch);
    }
    return patches;
  }

  void add_wall(std::uint32_t cube, bool in_inside, const Curves& curves) {
    const auto found = walls_->find(cube);
    if (found == walls_->end()) throw std::logic_error("a tunnel lacks its wall");
    ++walls_built_;
    const std::vector<std::uint32_t>& grid_edges = found->second;
    const auto curve_at = [&](int crossing) {
      std::size_t i = 0;
      while (!holds(complex_.edges[curves.segments.at(i)].boundary, crossing)) ++i;
      return curves.classes.of(static_cast<int>(i));
    };
    const int from = crossings_[grid_edges.front()];
    const int to = crossings_[grid_edges.back()];
    if (curve_at(from) == curve_at(to)) throw std::logic_error("a wall ends on one curve twice");
    ExplicitComplex::Cell wall{in_inside ? Place::inside : Place::outside, {}};
    for (const std::uint32_t edge : grid_edges) wall.boundary.push_back(edge_end(edge, in_inside));
    const auto middle = static_cast<int>(complex_.vertices.size());
    complex_.vertices.push_back(Place::on_m);
    for (const int end : {from, to}) {
      wall.boundary.push_back(static_cast<int>(complex_.edges.size()));
      complex_.edges.push_back({Place::on_m, ends_of(end, middle)});
    }
    std::sort(wall.boundary.begin(), wall.boundary.end());
    complex_.cube_of_wall[static_cast<int>(complex_.faces.size())] = cube;
    complex_.faces.push_back(std::move(wall));
  }

  const std::vector<double>& value_;
  Index3 dims_;
  const Lattice& box_;
  const std::optional<Walls>& walls_;
  std::size_t walls_built_ = 0;
  ExplicitComplex complex_;
  std::vector<bool> inside_;        // by lattice vertex
  std::vector<int> grid_vertices_;  // by lattice vertex
  std::vector<int> crossings_;      // by grid edge
  std::vector<int> edge_ends_;      // by grid edge and side
  std::vector<CutFace> faces_;      // by lattice face
};

}  // namespace

ExplicitComplex build_complex(const std::vector<double>& inside_value, const Index3& dims,
                              const Lattice& box, const std::optional<Walls>& walls) {
  return Builder(inside_value, dims, box, walls).build();
}

}  // namespace isoloop::oracle
