#include "core/surface/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include <tbb/parallel_for.h>

#include "core/base/disjoint_sets.h"
#include "core/base/errors.h"
#include "core/cube/cube_interior.h"
#include "core/grid/level.h"

namespace isoloop {
namespace {

/// How far vertices keep off the grid's vertices, in shares of an edge: enough for single precision
/// to tell them apart in the cube whose lowest corner is at `lower`.
double least_share(const Index3& lower) {
  constexpr double usual = 1e-3;
  const auto farthest = static_cast<float>(*std::max_element(lower.begin(), lower.end()) + 1);
  const float precision = std::nextafter(farthest, std::numeric_limits<float>::max()) - farthest;
  return std::max(usual, 2.0 * precision);
}

/// Where M crosses an edge, as a share of its length.
template <class T>
double share_from_lower(const GridView<T>& grid, const IsoLevel& level, const Index3& lower,
                        int axis) {
  Index3 upper = lower;
  ++upper[axis];
  const auto within = [&](const Index3& p) { return p[axis] >= 0 && p[axis] < grid.dims[axis]; };
  if (!within(lower) || !within(upper)) return 0.5;
  const auto at = [&](const Index3& p) {
    return level_of(grid.values[p[0] + grid.dims[0] * (p[1] + grid.dims[1] * p[2])], level);
  };
  const double from = at(lower);
  const double to = at(upper);
  const double gap = from - to;  // of two signs, so it may outgrow a double
  const double share = std::isfinite(gap) ? from / gap : from / 2 / (from / 2 - to / 2);
  return std::clamp(share, least_share(lower), 1.0 - least_share(lower));
}

template <class T>
void place_vertices(const GridView<T>& grid, const IsoLevel& level, const VoxelSides& sides,
                    const EdgeIndex& edges, Surface& surface) {
  tbb::parallel_for(std::uint32_t{0}, edges.block_count(), [&](std::uint32_t b) {
    edges.visit_block(b, [&](std::uint32_t vertex, std::uint32_t grid_edge) {
      const Index3 lower = sides.lattice.voxel_at(grid_edge / 3);
      const int axis = static_cast<int>(grid_edge % 3);
      for (int a = 0; a < 3; ++a) surface.points[vertex][a] = static_cast<float>(lower[a]);
      surface.points[vertex][axis] = static_cast<float>(static_cast<double>(lower[axis]) +
                                                        share_from_lower(grid, level, lower, axis));
      surface.grid_edges[vertex] = grid_edge;
    });
  });
}

template <class T>
void place_rings(const GridView<T>& grid, const IsoLevel& level, const VoxelSides& sides,
                 const EdgeIndex& edges, Surface& surface) {
  for (std::size_t t = 0; t < sides.tunnels.size(); ++t) {
    const auto& [cube, hub] = sides.tunnels[t];
    const Index3 lowest = sides.lattice.voxel_at(cube);
    const auto ring = tunnel_ring(corner_levels(grid, level, lowest), hub, least_share(lowest));
    for (int i = 0; i < ring_size; ++i)
      for (int a = 0; a < 3; ++a)
        surface.points[ring_vertex(edges, t, i)][a] =
            static_cast<float>(static_cast<double>(lowest[a]) + ring[i][a]);
  }
}

/// Calls visit(cube, cut) for the cut cubes of one layer, in scan order.
template <class Visit>
void for_each_cut_cube(const VoxelSides& sides, std::uint32_t layer, const Visit& visit) {
  const std::uint32_t begin = layer * sides.lattice.stride[2];
  for (std::uint32_t v = begin; v < begin + sides.lattice.stride[2]; ++v)
    if ((sides.cubes[v] & VoxelSides::is_cut) != 0) visit(v, cut_at(sides, v));
}

void triangulate(const VoxelSides& sides, const EdgeIndex& edges, Surface& surface) {
  const std::uint32_t layers = sides.lattice.dims[2];
  std::vector<std::int64_t> polygons(layers);
  std::vector<std::size_t> first(layers + 1);
  tbb::parallel_for(std::uint32_t{0}, layers, [&](std::uint32_t z) {
    for_each_cut_cube(sides, z, [&](std::uint32_t, const CubeCut& cut) {
      polygons[z] += cut.disc_count;
      first[z + 1] += cut.triangle_count;
    });
  });
  surface.polygons = std::accumulate(polygons.begin(), polygons.end(), std::int64_t{0});
  std::partial_sum(first.begin(), first.end(), first.begin());
  surface.triangles.resize(first.back());
  surface.triangle_cubes.resize(first.back());
  tbb::parallel_for(std::uint32_t{0}, layers, [&](std::uint32_t z) {
    std::size_t next = first[z];
    for_each_cut_cube(sides, z, [&](std::uint32_t cube, const CubeCut& cut) {
      const auto number = [&](int vertex) {
        return vertex < first_ring_vertex
                   ? edges.vertex_on(lattice_edge(sides.lattice, cube, vertex))
                   : ring_vertex(edges, tunnel_in(sides, cube), vertex - first_ring_vertex);
      };
      for (int t = 0; t < cut.triangle_count; ++t, ++next) {
        for (int i = 0; i < 3; ++i) surface.triangles[next][i] = number(cut.triangles[t][i]);
        surface.triangle_cubes[next] = cube;
      }
    });
  });
}

/// An edge that no other triangle runs along the other way lies on the border of the box, and so do
/// the grid edges of its ends.
std::vector<std::array<std::uint32_t, 2>> find_border(const VoxelSides& sides,
                                                      const Surface& surface) {
  if (sides.boundary == Boundary::closed) return {};
  struct Directed {
    std::array<std::uint32_t, 2> ends;  // ascending
    bool descends;
    auto operator<=>(const Directed&) const = default;
  };
  const auto near_border = [&](std::uint32_t vertex) {
    return vertex < surface.grid_edges.size() &&
           (sides.cubes[surface.grid_edges[vertex] / 3] & VoxelSides::on_border) != 0;
  };
  std::vector<Directed> found;
  for (const auto& triangle : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t u = triangle[i];
      const std::uint32_t v = triangle[(i + 1) % 3];
      if (near_border(u) && near_border(v))
        found.push_back({{std::min(u, v), std::max(u, v)}, u > v});
    }
  std::sort(found.begin(), found.end());
  std::vector<std::array<std::uint32_t, 2>> border;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& [a, b] = found[i].ends;
    if (i + 1 < found.size() && found[i + 1].ends == found[i].ends) {
      ++i;  // both directions are there
    } else if (found[i].descends) {
      border.push_back({b, a});
    } else {
      border.push_back({a, b});
    }
  }
  return border;
}

/// Edges that leave each vertex, in the order of the triangles that they run along; then those that
/// run along a border edge the other way.
EdgeGraph::Csr directed_edges(const Surface& surface) {
  std::vector<std::uint32_t> next(surface.points.size() + 1);  // place for an edge of each vertex
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t source : triangle) ++next[source + 1];
  for (const auto& [from, to] : surface.border_edges) ++next[to + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges(next.back());
  for (const auto& triangle : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      edges[next[triangle[i]]++] = {triangle[i], triangle[(i + 1) % 3]};
  for (const auto& [from, to] : surface.border_edges) edges[next[to]++] = {to, from};
  return {boost::edges_are_sorted, edges.begin(), edges.end(),
          static_cast<std::uint32_t>(surface.points.size()),
          static_cast<std::uint32_t>(edges.size())};
}

/// What searches on M rely on to end.
void check_length(const Surface& surface, float length, std::uint32_t from, std::uint32_t to) {
  if (length > 0.0F && std::isfinite(length)) return;
  const auto& p = surface.points[from];
  throw SelfCheckFailed("the edge of the surface from its vertex " + std::to_string(from) + " to " +
                        std::to_string(to) + " has the length " + std::to_string(length) +
                        ", near voxel (" + std::to_string(p[0]) + ", " + std::to_string(p[1]) +
                        ", " + std::to_string(p[2]) + ")");
}

void build_graph(Surface& surface) {
  EdgeGraph& graph = surface.graph;
  graph.csr = directed_edges(surface);
  graph.lengths.resize(num_edges(graph.csr));
  tbb::parallel_for(std::uint32_t{0}, graph.vertex_count(), [&](std::uint32_t u) {
    const Vec3 p = scaled_point(surface, u);
    graph.for_each_out_edge(u, [&](std::uint32_t v, std::uint32_t edge) {
      graph.lengths[edge] = static_cast<float>(distance(p, scaled_point(surface, v)));
      check_length(surface, graph.lengths[edge], u, v);
    });
  });
}

/// Where M is closed, a component's first crossing of any grid row leads into the region that it
/// encloses; so the side before its first vertex on an x-edge tells whether it encloses I or O.
void number_components(const VoxelSides& sides, Surface& surface) {
  const auto count = static_cast<std::uint32_t>(surface.points.size());
  DisjointSets sets(count);
  for (const auto& [a, b, c] : surface.triangles) {
    sets.unite(a, b);
    sets.unite(a, c);
  }
  constexpr auto unseen = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(count, unseen);
  std::vector<std::uint8_t> oriented;
  surface.component_of_vertex.resize(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    std::uint32_t& component = number[sets.find(v)];
    if (component == unseen) {
      component = static_cast<std::uint32_t>(surface.components.size());
      surface.components.emplace_back();
      oriented.push_back(0);
    }
    surface.component_of_vertex[v] = component;
    ++surface.components[component].vertices;
    if (v >= surface.grid_edges.size() || oriented[component] != 0) continue;
    const std::uint32_t edge = surface.grid_edges[v];
    if (edge % 3 != 0) continue;
    oriented[component] = 1;
    surface.components[component].bounds_cavity =
        sides.boundary == Boundary::closed && sides.is_on(Side::inside, edge / 3);
  }
  for (const auto& triangle : surface.triangles)
    ++surface.components[surface.component_of_vertex[triangle[0]]].triangles;
  std::vector<std::int64_t> border_edges(surface.components.size());
  DisjointSets curves(surface.border_edges.empty() ? 0 : count);
  for (const auto& [from, to] : surface.border_edges) {
    const std::uint32_t component = surface.component_of_vertex[from];
    ++border_edges[component];
    // The edge that closes a curve joins nothing.
    if (!curves.unite(from, to)) ++surface.components[component].borders;
  }
  for (std::size_t c = 0; c < surface.components.size(); ++c) {
    SurfaceComponent& component = surface.components[c];
    component.euler = component.vertices - (component.triangles + border_edges[c]) / 2;
    component.genus = (2 - component.borders - component.euler) / 2;
  }
}

}  // namespace

std::int64_t Surface::euler() const {
  return static_cast<std::int64_t>(points.size()) -
         static_cast<std::int64_t>(triangles.size() + border_edges.size()) / 2;
}

std::int64_t Surface::genus() const {
  std::int64_t sum = 0;
  for (const SurfaceComponent& component : components) sum += component.genus;
  return sum;
}

std::int64_t Surface::betti1() const {
  std::int64_t sum = 0;
  for (const SurfaceComponent& component : components) sum += component.betti1();
  return sum;
}

Surface extract_surface(const AnyGridView& grid, const IsoLevel& level, const VoxelSides& sides,
                        const EdgeIndex& edges, bool with_graph) {
  Surface surface;
  surface.spacing = std::visit([](const auto& view) { return view.spacing; }, grid);
  surface.boundary = sides.boundary;
  if (sides.empty()) return surface;
  surface.points.resize(ring_vertex(edges, sides.tunnels.size(), 0));
  surface.grid_edges.resize(edges.count());
  const auto place = [&](const auto& view) {
    place_vertices(view, level, sides, edges, surface);
    place_rings(view, level, sides, edges, surface);
  };
  std::visit(place, grid);
  triangulate(sides, edges, surface);
  surface.border_edges = find_border(sides, surface);
  if (with_graph) build_graph(surface);
  number_components(sides, surface);
  return surface;
}

Vec3 scaled_point(const Surface& surface, std::uint32_t vertex) {
  const auto& p = surface.points[vertex];
  return {p[0] * surface.spacing[0], p[1] * surface.spacing[1], p[2] * surface.spacing[2]};
}

double scaled_distance(const Surface& surface, const Vec3& p, const Vec3& q) {
  const Vec3& spacing = surface.spacing;
  return std::hypot(spacing[0] * (q[0] - p[0]), spacing[1] * (q[1] - p[1]),
                    spacing[2] * (q[2] - p[2]));
}

}  // namespace isoloop
