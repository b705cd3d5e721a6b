// A volume as it is after some changes, with the box and the numbers that it had before them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/cube/cube_interior.h"
#include "core/cube/voxel_sides.h"
#include "core/grid/grid.h"
#include "core/repair/voxel_values.h"

namespace isoloop {

/// Stands for all that lies beyond the box: outside, and one part.
inline constexpr std::uint32_t beyond_box = std::numeric_limits<std::uint32_t>::max();

/// Which side each lattice vertex is on, and what of a side hangs together at a vertex.
class CurrentVolume {
 public:
  /// Keeps references. `sides`: classify() of `values`, with a closed boundary. From now on
  /// `values` change by set() alone.
  CurrentVolume(const VoxelSides& sides, const IsoLevel& level, VoxelValues& values);

  /// `voxel`: of the grid, and one of the lattice's. `value`: as VoxelValues::set() wants it.
  void set(std::size_t voxel, double value);

  bool is_inside(std::uint32_t vertex) const {
    return vertex != beyond_box && inside_[vertex] != 0;
  }

  /// The lattice's vertex at the voxel, which may lie round the grid; or beyond_box.
  std::uint32_t vertex_at(const Index3& voxel) const {
    return sides_.lattice.vertex_at(voxel).value_or(beyond_box);
  }

  /// How M cuts the cube with that voxel as its lowest corner, which may lie round the grid.
  DecidedCube cube_at(const Index3& lowest) const;

  /// Calls visit(vertex) for each one that hangs together with this one, on its side, along a grid
  /// edge or within a cube, and perhaps more than once; with beyond_box if that does.
  template <class Visit>
  void for_each_joined(std::uint32_t vertex, const Visit& visit) const;

  const Lattice& lattice() const { return sides_.lattice; }
  const VoxelValues& values() const { return values_; }

 private:
  bool hangs_together_along_edges(std::uint32_t cube, bool inside) const;

  const VoxelSides& sides_;
  IsoLevel level_;
  VoxelValues& values_;
  std::vector<std::uint8_t> inside_;  // by lattice vertex: 1 if in I now
};

template <class Visit>
void CurrentVolume::for_each_joined(std::uint32_t vertex, const Visit& visit) const {
  const Lattice& lattice = sides_.lattice;
  const bool inside = is_inside(vertex);
  const auto p = lattice.position(vertex);
  std::uint32_t lowest = vertex;
  bool is_on_border = false;
  for (std::size_t a = 0; a < 3; ++a) {
    const bool is_first = p[a] == 0;
    const bool is_last = p[a] + 1 == lattice.dims[a];
    if (!is_first && is_inside(vertex - lattice.stride[a]) == inside)
      visit(vertex - lattice.stride[a]);
    if (!is_last && is_inside(vertex + lattice.stride[a]) == inside)
      visit(vertex + lattice.stride[a]);
    is_on_border = is_on_border || is_first || is_last;
    if (!is_first) lowest -= lattice.stride[a];
  }
  if (is_on_border && !inside) return visit(beyond_box);
  for (unsigned n = 0; n < 8; ++n) {
    const bool is_in_box = (p[0] != 0 || (n & 1U) == 0) && (p[1] != 0 || (n & 2U) == 0) &&
                           (p[2] != 0 || (n & 4U) == 0);
    const std::uint32_t cube = lattice.corner(lowest, n);
    const auto q = lattice.position(cube);
    if (!is_in_box || q[0] + 1 >= lattice.dims[0] || q[1] + 1 >= lattice.dims[1] ||
        q[2] + 1 >= lattice.dims[2] || hangs_together_along_edges(cube, inside))
      continue;
    const CubeCut& cut = *cube_at(lattice.voxel_at(cube)).cut;
    const unsigned own = (p[0] - q[0]) | (p[1] - q[1]) << 1 | (p[2] - q[2]) << 2;
    for (unsigned c = 0; c < 8; ++c) {
      const std::uint32_t corner = lattice.corner(cube, c);
      if (is_inside(corner) == inside && cut.cell_of_corner[c] == cut.cell_of_corner[own])
        visit(corner);
    }
  }
}

}  // namespace isoloop
