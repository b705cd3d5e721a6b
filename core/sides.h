// Which side of M each grid vertex lies on, and how the ambiguous faces are decided: all that the
// combinatorics of M and K depend on.
#pragma once

#include <cstdint>
#include <vector>

#include "core/cube.h"
#include "core/grid.h"
#include "core/lattice.h"

namespace isoloop {

/// The box that K fills: the bounding box of the inside voxels and one layer of outside vertices
/// around it. Beyond it O is one cell. Empty (all dims 0) where no voxel is inside.
struct Sides {
  Lattice lattice;
  std::vector<std::uint8_t> inside;  // 1 for each lattice vertex in I, else 0
  std::vector<std::uint8_t> cubes;   // by lowest corner: Flag bits

  enum Flag : std::uint8_t {
    lower_face_joined = 1,  // shifted by the axis: the face with this lowest corner and that normal
    is_cut = 8,             // M passes through
    many_outside_cells = 16,
    many_inside_cells = 32,
    on_border = 64,            // this grid vertex lies on the box's border
    has_ambiguous_face = 128,  // among the three faces with this lowest corner
  };

  bool empty() const { return inside.empty(); }
  bool is_on(Side side, std::uint32_t vertex) const {
    return inside[vertex] == static_cast<std::uint8_t>(side);
  }
};

/// Decides every voxel (f = iso is inside) and every ambiguous face. Voxels beyond the grid are
/// outside. Infinite values count as very large ones. Throws InvalidInput where a voxel is NaN,
/// InvalidArgument for an empty grid or a NaN iso, LimitExceeded over max_lattice_vertices.
Sides classify(const AnyGridView& grid, const IsoLevel& level);

/// Corner bits of the cube with lowest corner `vertex`, as cube_cut() wants them.
std::uint8_t inside_corners(const Sides& sides, std::uint32_t vertex);

/// Joined bits of its six faces, as cube_cut() wants them.
std::uint8_t joined_faces(const Sides& sides, std::uint32_t vertex);

/// How M cuts the cube with lowest corner `vertex`.
const CubeCut& cut_at(const Sides& sides, std::uint32_t vertex);

}  // namespace isoloop
