#include "core/cube/voxel_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include "core/base/errors.h"
#include "core/cube/cube_interior.h"
#include "core/grid/level.h"

namespace isoloop {
namespace {

/// Smallest box of voxels that holds all those inside; empty while lower > upper.
struct Bounds {
  Index3 lower{std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::max(),
               std::numeric_limits<std::int64_t>::max()};
  Index3 upper{-1, -1, -1};
  std::int64_t first_nan = std::numeric_limits<std::int64_t>::max();

  void include(std::int64_t x0, std::int64_t x1, std::int64_t y, std::int64_t z) {
    lower = {std::min(lower[0], x0), std::min(lower[1], y), std::min(lower[2], z)};
    upper = {std::max(upper[0], x1), std::max(upper[1], y), std::max(upper[2], z)};
  }
  static Bounds join(const Bounds& a, const Bounds& b) {
    Bounds all = a;
    for (int i = 0; i < 3; ++i) {
      all.lower[i] = std::min(a.lower[i], b.lower[i]);
      all.upper[i] = std::max(a.upper[i], b.upper[i]);
    }
    all.first_nan = std::min(a.first_nan, b.first_nan);
    return all;
  }
};

template <class T>
void scan_row(const GridView<T>& grid, const InsideValues& inside, std::int64_t y, std::int64_t z,
              Bounds& bounds) {
  const std::int64_t start = grid.dims[0] * (y + grid.dims[1] * z);
  const T* row = grid.values.data() + start;
  std::int64_t first = grid.dims[0];
  std::int64_t last = -1;
  for (std::int64_t x = 0; x < grid.dims[0]; ++x) {
    if constexpr (std::is_floating_point_v<T>)
      if (std::isnan(row[x])) bounds.first_nan = std::min(bounds.first_nan, start + x);
    if (!inside.hold(row[x])) continue;
    first = std::min(first, x);
    last = x;
  }
  if (last >= 0) bounds.include(first, last, y, z);
}

template <class T>
Bounds inside_bounds(const GridView<T>& grid, const IsoLevel& level) {
  const InsideValues inside = inside_values(level);
  return tbb::parallel_reduce(
      tbb::blocked_range<std::int64_t>(0, grid.dims[2]), Bounds{},
      [&](const tbb::blocked_range<std::int64_t>& slab, Bounds bounds) {
        for (std::int64_t z = slab.begin(); z < slab.end(); ++z)
          for (std::int64_t y = 0; y < grid.dims[1]; ++y) scan_row(grid, inside, y, z, bounds);
        return bounds;
      },
      Bounds::join);
}

template <class T>
void check_grid(const GridView<T>& grid, const IsoLevel& level) {
  std::int64_t count = 1;
  for (const std::int64_t n : grid.dims) count *= n;
  if (count <= 0 || static_cast<std::int64_t>(grid.values.size()) != count)
    throw InvalidArgument({.text = "the grid's dimensions do not fit its number of voxels"},
                          Option::dims);
  if (std::isnan(level.iso))
    throw InvalidArgument({.about = Option::iso, .text = "is NaN: give a number"});
  if (level.upper && (level.inside == InsideRule::below || !(*level.upper >= level.iso)))
    throw InvalidArgument(
        {.text = "of two iso values, between which the inside lies, the second is the "
                 "larger, and the inside is above the first"},
        Option::iso);
  for (const double length : grid.spacing)
    if (!is_spacing(length))
      throw InvalidArgument(
          {.about = Option::spacing, .text = "must lie between 1e-18 and 1e18 along each axis"});
}

Lattice lattice_around(const Bounds& bounds, const Index3& grid_dims, Boundary boundary) {
  Index3 first{};
  std::array<std::uint32_t, 3> dims{};
  std::uint64_t count = 1;
  for (int a = 0; a < 3; ++a) {
    first[a] = bounds.lower[a] - 1;
    std::int64_t last = bounds.upper[a] + 1;
    if (boundary == Boundary::open) {
      first[a] = std::max<std::int64_t>(first[a], 0);
      last = std::min(last, grid_dims[a] - 1);
    }
    if (last > max_voxel_index)
      throw LimitExceeded({.text = "the solid lies beyond voxel " +
                                   std::to_string(max_voxel_index) +
                                   " along an axis, too far for the precision of its surface",
                           .advice = {Advice::take_part}});
    const auto extent = static_cast<std::uint64_t>(last - first[a]) + 1;
    if (extent > max_lattice_vertices || count * extent > max_lattice_vertices)
      throw LimitExceeded({.text = "the solid's bounding box has more than " +
                                   std::to_string(max_lattice_vertices) + " voxels",
                           .advice = {Advice::take_part, Advice::halve_resolution}},
                          {.unit = Excess::Unit::voxels, .limit = max_lattice_vertices});
    count *= extent;
    dims[a] = static_cast<std::uint32_t>(extent);
  }
  return make_lattice(first, dims);
}

template <class Body>
void for_each_layer(const Lattice& lattice, const Body& body) {
  tbb::parallel_for(std::uint32_t{0}, lattice.dims[2], body);
}

template <class T>
void mark_inside(const GridView<T>& grid, const IsoLevel& level, VoxelSides& sides) {
  const Lattice& lattice = sides.lattice;
  const InsideValues inside = inside_values(level);
  const auto in_grid = [&](std::uint32_t i, int axis) {
    const std::int64_t at = lattice.first[axis] + i;
    return at >= 0 && at < grid.dims[axis];
  };
  for_each_layer(lattice, [&](std::uint32_t z) {
    if (!in_grid(z, 2)) return;
    for (std::uint32_t y = 0; y < lattice.dims[1]; ++y) {
      if (!in_grid(y, 1)) continue;
      const std::int64_t row =
          grid.dims[0] * (lattice.first[1] + y + grid.dims[1] * (lattice.first[2] + z));
      const auto begin = static_cast<std::uint32_t>(in_grid(0, 0) ? 0 : 1);
      const std::uint32_t end = lattice.dims[0] - (in_grid(lattice.dims[0] - 1, 0) ? 0 : 1);
      const T* from = grid.values.data() + row + lattice.first[0] + begin;
      std::uint8_t* to = sides.inside.data() + lattice.vertex(begin, y, z);
      for (std::uint32_t x = 0; x < end - begin; ++x) to[x] = inside.hold(from[x]);
    }
  });
}

/// Reads an ambiguous face's values; it never leaves the grid: of two neighbours one is inside.
template <class T>
DecidedFaces faces_of(const GridView<T>& grid, const IsoLevel& level, const Lattice& lattice,
                      const std::array<std::uint32_t, 3>& p, std::uint8_t corners) {
  return decide_faces(corners, [&](int corner) {
    const std::int64_t x = lattice.first[0] + p[0] + (corner & 1);
    const std::int64_t y = lattice.first[1] + p[1] + (corner >> 1 & 1);
    const std::int64_t z = lattice.first[2] + p[2] + (corner >> 2 & 1);
    const T value = grid.values[x + grid.dims[0] * (y + grid.dims[1] * z)];
    return deciding_level(level_of(value, level), level.topology);
  });
}

/// A face on the far border of the box is no cube's lower face: the cube before it decides it. It
/// can be ambiguous only where the boundary is open.
void mark_far_faces(const DecidedFaces& faces, const std::array<std::uint32_t, 3>& p,
                    VoxelSides& sides) {
  const Lattice& lattice = sides.lattice;
  for (int a = 0; a < 3; ++a) {
    const unsigned upper = 2U << (2 * a);
    if (p[a] + 2 != lattice.dims[a] || (faces.ambiguous & upper) == 0) continue;
    unsigned flags = VoxelSides::has_ambiguous_face;
    if ((faces.joined & upper) != 0) flags |= unsigned{VoxelSides::lower_face_joined} << a;
    sides.cubes[lattice.vertex(p[0], p[1], p[2]) + lattice.stride[a]] |=
        static_cast<std::uint8_t>(flags);
  }
}

/// The cube's cut without a tunnel has room for one only where all its corners lie in the grid.
template <class T>
std::optional<int> find_hub(const GridView<T>& grid, const IsoLevel& level, const Lattice& lattice,
                            std::uint32_t cube, const CubeCut& cut) {
  if (level.topology == Topology::simple || cut.hubs.count == 0) return std::nullopt;
  return tunnel_hub(cut, corner_levels(grid, level, lattice.voxel_at(cube)));
}

template <class T>
void mark_cubes(const GridView<T>& grid, const IsoLevel& level, VoxelSides& sides) {
  const Lattice& lattice = sides.lattice;
  std::vector<std::vector<VoxelSides::Tunnel>> tunnels(lattice.dims[2]);
  tbb::parallel_for(std::uint32_t{0}, lattice.dims[2] - 1, [&](std::uint32_t z) {
    for (std::uint32_t y = 0; y + 1 < lattice.dims[1]; ++y)
      for (std::uint32_t x = 0; x + 1 < lattice.dims[0]; ++x) {
        const std::uint32_t v = lattice.vertex(x, y, z);
        const std::uint8_t corners = inside_corners(sides, v);
        if (corners == 0 || corners == 255) continue;
        const DecidedFaces faces = faces_of(grid, level, lattice, {x, y, z}, corners);
        unsigned flags = VoxelSides::is_cut;
        for (int a = 0; a < 3; ++a)
          flags |= (faces.joined >> (2 * a) & 1U) * VoxelSides::lower_face_joined << a;
        if ((faces.ambiguous & 0b010101U) != 0) flags |= VoxelSides::has_ambiguous_face;
        const auto joined = static_cast<std::uint8_t>(faces.joined);
        const CubeCut& plain = cube_cut(corners, joined, false);
        const std::optional<int> hub = find_hub(grid, level, lattice, v, plain);
        if (hub) tunnels[z].push_back({v, static_cast<std::uint8_t>(*hub)});
        const CubeCut& cut = hub ? tunnel_cut(corners, joined, false, *hub).cut : plain;
        if (cut.cell_count[0] > 1) flags |= VoxelSides::many_outside_cells;
        if (cut.cell_count[1] > 1) flags |= VoxelSides::many_inside_cells;
        sides.cubes[v] |= static_cast<std::uint8_t>(flags);
        mark_far_faces(faces, {x, y, z}, sides);
      }
  });
  for (const auto& layer : tunnels)
    sides.tunnels.insert(sides.tunnels.end(), layer.begin(), layer.end());
}

void mark_border(VoxelSides& sides) {
  const Lattice& lattice = sides.lattice;
  const auto is_end = [&](std::uint32_t i, int axis) {
    return i == 0 || i + 1 == lattice.dims[axis];
  };
  for_each_layer(lattice, [&](std::uint32_t z) {
    for (std::uint32_t y = 0; y < lattice.dims[1]; ++y) {
      const bool whole_row = is_end(y, 1) || is_end(z, 2);
      const std::uint32_t step = whole_row ? 1 : lattice.dims[0] - 1;
      for (std::uint32_t x = 0; x < lattice.dims[0]; x += step)
        sides.cubes[lattice.vertex(x, y, z)] |= VoxelSides::on_border;
    }
  });
}

template <class T>
VoxelSides classify_grid(const GridView<T>& grid, const IsoLevel& level, Boundary boundary,
                         std::uint64_t max_bytes) {
  check_grid(grid, level);
  if (boundary == Boundary::open && *std::min_element(grid.dims.begin(), grid.dims.end()) < 2)
    throw InvalidArgument(
        {.text = "an open boundary needs two voxels or more along each axis, not " +
                 std::to_string(grid.dims[0]) + " x " + std::to_string(grid.dims[1]) + " x " +
                 std::to_string(grid.dims[2])},
        Option::boundary);
  const Bounds bounds = inside_bounds(grid, level);
  if (bounds.first_nan != std::numeric_limits<std::int64_t>::max()) {
    const std::int64_t n = bounds.first_nan;
    throw InvalidInput({.place = "voxel (" + std::to_string(n % grid.dims[0]) + ", " +
                                 std::to_string(n / grid.dims[0] % grid.dims[1]) + ", " +
                                 std::to_string(n / grid.dims[0] / grid.dims[1]) + ")",
                        .text = "NaN",
                        .advice = {Advice::replace_nan}},
                       Fault::not_finite);
  }
  VoxelSides sides;
  sides.boundary = boundary;
  if (bounds.upper[0] < 0) return sides;
  sides.lattice = lattice_around(bounds, grid.dims, boundary);
  check_memory("surface", surface_bytes(sides.lattice.vertex_count(), 0), max_bytes);
  sides.inside.assign(sides.lattice.vertex_count(), 0);
  sides.cubes.assign(sides.lattice.vertex_count(), 0);
  mark_inside(grid, level, sides);
  mark_border(sides);
  mark_cubes(grid, level, sides);
  return sides;
}

}  // namespace

VoxelSides classify(const AnyGridView& grid, const IsoLevel& level, Boundary boundary,
                    std::uint64_t max_bytes) {
  return std::visit(
      [&](const auto& view) { return classify_grid(view, level, boundary, max_bytes); }, grid);
}

std::uint8_t inside_corners(const VoxelSides& sides, std::uint32_t vertex) {
  const std::uint8_t* p = sides.inside.data() + vertex;
  const std::uint32_t dy = sides.lattice.stride[1];
  const std::uint32_t dz = sides.lattice.stride[2];
  return static_cast<std::uint8_t>(p[0] | p[1] << 1 | p[dy] << 2 | p[dy + 1] << 3 | p[dz] << 4 |
                                   p[dz + 1] << 5 | p[dz + dy] << 6 | p[dz + dy + 1] << 7);
}

std::uint8_t joined_faces(const VoxelSides& sides, std::uint32_t vertex) {
  unsigned joined = 0;
  for (int a = 0; a < 3; ++a) {
    const unsigned bit = unsigned{VoxelSides::lower_face_joined} << a;
    if ((sides.cubes[vertex] & bit) != 0) joined |= 1U << (2 * a);
    if ((sides.cubes[vertex + sides.lattice.stride[a]] & bit) != 0) joined |= 2U << (2 * a);
  }
  return static_cast<std::uint8_t>(joined);
}

namespace {

bool is_odd(const VoxelSides& sides, std::uint32_t vertex) {
  const Index3 voxel = sides.lattice.voxel_at(vertex);
  return ((voxel[0] + voxel[1] + voxel[2]) & 1) != 0;
}

}  // namespace

const CubeCut& cut_at(const VoxelSides& sides, std::uint32_t vertex) {
  const CubeCut& plain =
      cube_cut(inside_corners(sides, vertex), joined_faces(sides, vertex), is_odd(sides, vertex));
  if (plain.hubs.count == 0) return plain;
  const std::size_t tunnel = tunnel_in(sides, vertex);
  return tunnel == sides.tunnels.size() ? plain : cut_at(sides, sides.tunnels[tunnel]).cut;
}

const TunnelCut& cut_at(const VoxelSides& sides, const VoxelSides::Tunnel& tunnel) {
  return tunnel_cut(inside_corners(sides, tunnel.cube), joined_faces(sides, tunnel.cube),
                    is_odd(sides, tunnel.cube), tunnel.hub);
}

std::size_t tunnel_in(const VoxelSides& sides, std::uint32_t vertex) {
  const auto at = std::lower_bound(
      sides.tunnels.begin(), sides.tunnels.end(), vertex,
      [](const VoxelSides::Tunnel& tunnel, std::uint32_t cube) { return tunnel.cube < cube; });
  const bool found = at != sides.tunnels.end() && at->cube == vertex;
  return static_cast<std::size_t>((found ? at : sides.tunnels.end()) - sides.tunnels.begin());
}

}  // namespace isoloop
