#include "tests/oracles/tetrahedra.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace isoloop::oracle {
namespace {

using Corners = std::vector<std::uint32_t>;  // grid vertices, ascending

struct Tetrahedron {
  Corners corners;
  bool inside;
};

class Box {
 public:
  explicit Box(const std::vector<std::string>& rows)
      : rows_(rows),
        nx_(static_cast<std::uint32_t>(rows.front().size()) + 3),
        ny_(static_cast<std::uint32_t>(rows.size()) + 3) {
    for (std::uint32_t z = 0; z < 3; ++z)
      for (std::uint32_t y = 0; y + 1 < ny_; ++y)
        for (std::uint32_t x = 0; x + 1 < nx_; ++x) cut_cube(x, y, z);
    for (std::uint32_t t = 0; t < tetrahedra_.size(); ++t)
      for (std::size_t left_out = 0; left_out < 4; ++left_out) {
        Corners face = tetrahedra_[t].corners;
        face.erase(face.begin() + static_cast<std::ptrdiff_t>(left_out));
        faces_[face].push_back(t);
      }
    find_surface();
  }

  TetrahedralVolume volume() { return {std::move(surface_), side(true), side(false)}; }

 private:
  void cut_cube(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    const bool inside = z == 1 && y >= 1 && y <= rows_.size() && x >= 1 &&
                        x <= rows_.front().size() && rows_[y - 1][x - 1] == '#';
    const std::array<std::uint32_t, 3> stride{1, nx_, nx_ * ny_};
    std::array<std::size_t, 3> axes{0, 1, 2};
    do {
      Corners corners{x + nx_ * (y + ny_ * z)};
      for (const std::size_t axis : axes) corners.push_back(corners.back() + stride[axis]);
      tetrahedra_.push_back({corners, inside});
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  std::array<std::int64_t, 3> place(std::uint32_t vertex) const {
    return {vertex % nx_, vertex / nx_ % ny_, vertex / nx_ / ny_};
  }

  /// Whether the triangle turns counter-clockwise as seen from the other side of `from`.
  bool faces_away(const Corners& t, std::uint32_t from) const {
    std::array<std::array<std::int64_t, 3>, 3> d{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t a = 0; a < 3; ++a) d[i][a] = place(t[i])[a] - place(from)[a];
    return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
               d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
               d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]) >
           0;
  }

  bool is_on_surface(const std::vector<std::uint32_t>& cells) const {
    return cells.size() == 2 && tetrahedra_[cells[0]].inside != tetrahedra_[cells[1]].inside;
  }

  std::uint32_t vertex_on_surface(std::uint32_t grid_vertex) {
    const auto [at, is_new] =
        vertex_of_.try_emplace(grid_vertex, static_cast<std::uint32_t>(surface_.points.size()));
    if (is_new) {
      const auto p = place(grid_vertex);
      surface_.points.push_back(
          {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
    }
    return at->second;
  }

  void find_surface() {
    std::set<std::pair<std::uint32_t, std::uint32_t>> directed;
    for (const auto& entry : faces_) {
      const auto& face = entry.first;  // a lambda cannot capture a structured binding
      const auto& cells = entry.second;
      if (!is_on_surface(cells)) continue;
      const Corners& within = tetrahedra_[cells[tetrahedra_[cells[0]].inside ? 0 : 1]].corners;
      const std::uint32_t apex = *std::find_if(within.begin(), within.end(), [&](std::uint32_t v) {
        return std::find(face.begin(), face.end(), v) == face.end();
      });
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t i = 0; i < 3; ++i) triangle[i] = vertex_on_surface(face[i]);
      if (!faces_away(face, apex)) std::swap(triangle[0], triangle[1]);
      surface_.triangles.push_back(triangle);
      for (std::size_t i = 0; i < 3; ++i) {
        edges_on_surface_.insert({face[i == 2 ? 0 : i], face[i == 2 ? 2 : i + 1]});
        directed.emplace(triangle[i], triangle[(i + 1) % 3]);
      }
    }
    SurfaceComponent component;
    component.vertices = static_cast<std::int64_t>(surface_.points.size());
    component.triangles = static_cast<std::int64_t>(surface_.triangles.size());
    component.euler = component.vertices - component.triangles / 2;
    component.genus = (2 - component.euler) / 2;
    surface_.components.push_back(component);
    surface_.component_of_vertex.resize(surface_.points.size());
    surface_.graph.csr = EdgeGraph::Csr(boost::edges_are_sorted, directed.begin(), directed.end(),
                                        static_cast<std::uint32_t>(surface_.points.size()),
                                        static_cast<std::uint32_t>(directed.size()));
    for (const auto& [from, to] : directed)
      surface_.graph.lengths.push_back(
          static_cast<float>(distance(scaled_point(surface_, from), scaled_point(surface_, to))));
  }

  /// Beyond the box lies one more cell, of the outside.
  FlatComplex side(bool inside) {
    const auto beyond = static_cast<std::uint32_t>(tetrahedra_.size());
    std::vector<FlatPiece> pieces;
    for (const auto& [face, cells] : faces_) {
      if (tetrahedra_[cells[0]].inside != inside || is_on_surface(cells)) continue;
      FlatPiece& piece = pieces.emplace_back();
      piece.cells = {cells[0], cells.size() == 2 ? cells[1] : beyond};
      for (const auto& [a, b] : {std::array{face[0], face[1]}, std::array{face[1], face[2]},
                                 std::array{face[0], face[2]}}) {
        if (edges_on_surface_.count({a, b}) > 0)
          piece.segments.push_back({vertex_of_.at(a), vertex_of_.at(b)});
        else
          piece.edges.push_back(
              edge_numbers_.try_emplace({a, b}, static_cast<std::uint32_t>(edge_numbers_.size()))
                  .first->second);
      }
    }
    return FlatComplex(beyond + 1, static_cast<std::uint32_t>(edge_numbers_.size()), pieces);
  }

  const std::vector<std::string>& rows_;
  std::uint32_t nx_;  // grid vertices
  std::uint32_t ny_;
  std::vector<Tetrahedron> tetrahedra_;
  std::map<Corners, std::vector<std::uint32_t>> faces_;
  std::map<std::uint32_t, std::uint32_t> vertex_of_;  // of M, by grid vertex
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges_on_surface_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edge_numbers_;
  Surface surface_;
};

}  // namespace

TetrahedralVolume tetrahedra_of(const std::vector<std::string>& rows) { return Box(rows).volume(); }

}  // namespace isoloop::oracle
