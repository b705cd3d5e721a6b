// Which side of M each grid vertex lies on, how the ambiguous faces are decided and where a cube
// has an interior tunnel: all that the combinatorics of M and K depend on.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/memory_budget.h"
#include "core/cube/cube.h"
#include "core/grid/grid.h"
#include "core/grid/lattice.h"

namespace isoloop {

/// The box that K fills: the bounding box of the inside voxels and one layer of outside vertices
/// around it, which an open boundary clips to the grid. Beyond it each side is one cell. Empty (all
/// dims 0) where no voxel is inside.
struct VoxelSides {
  /// A cube within which a tunnel of M joins two cells of the hub's side (see TunnelCut).
  struct Tunnel {
    std::uint32_t cube;
    std::uint8_t hub;

    friend bool operator==(const Tunnel& a, const Tunnel& b) = default;
  };

  Lattice lattice;
  Boundary boundary = Boundary::closed;
  std::vector<std::uint8_t> inside;  // 1 for each lattice vertex in I, else 0
  std::vector<std::uint8_t> cubes;   // by lowest corner: Flag bits
  std::vector<Tunnel> tunnels;       // ascending by cube

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

/// Decides every voxel (f = iso is inside), every ambiguous face and, but for Topology::simple,
/// every interior tunnel. Infinite values count as very large ones. Throws InvalidInput where a
/// voxel is NaN, InvalidArgument for an empty grid, a NaN iso, and one voxel along an axis with an
/// open boundary, LimitExceeded over max_lattice_vertices or where the box takes more than
/// `max_bytes`.
VoxelSides classify(const AnyGridView& grid, const IsoLevel& level,
                    Boundary boundary = Boundary::closed,
                    std::uint64_t max_bytes = unlimited_bytes);

/// Corner bits of the cube with lowest corner `vertex`, as cube_cut() wants them.
std::uint8_t inside_corners(const VoxelSides& sides, std::uint32_t vertex);

/// Joined bits of its six faces, as cube_cut() wants them.
std::uint8_t joined_faces(const VoxelSides& sides, std::uint32_t vertex);

/// How M cuts the cube with lowest corner `vertex`.
const CubeCut& cut_at(const VoxelSides& sides, std::uint32_t vertex);

/// The same for a cube with a tunnel, one of sides.tunnels.
const TunnelCut& cut_at(const VoxelSides& sides, const VoxelSides::Tunnel& tunnel);

/// The number of the cube's tunnel in sides.tunnels; their number if it has none.
std::size_t tunnel_in(const VoxelSides& sides, std::uint32_t vertex);

/// The side whose cells the tunnel joins.
inline Side joined_side(const VoxelSides& sides, const VoxelSides::Tunnel& tunnel) {
  return (inside_corners(sides, tunnel.cube) >> tunnel.hub & 1) != 0 ? Side::inside : Side::outside;
}

}  // namespace isoloop
