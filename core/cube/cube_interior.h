// Whether the trilinear interpolant within a cube has an interior tunnel: a part of it where the
// zero set is a tube that joins two parts of one side, which the cube's surface keeps apart.
//
// Cut the cube by planes across an axis. The four edges along it carry linear functions A, B, C, D
// (in ring order), and a plane's slice is bilinear: its parts are discs, and there are two of one
// side only where the signs alternate; then the sign of q = A C - B D, a quadratic along the axis,
// says which opposite corners are joined. So the parts of a side within the cube, and its cycles,
// are those of the graph of the slices' parts. A cycle opens where a part splits and closes where
// two parts meet again, both at roots of q within one stretch of alternating signs. There are at
// most two roots, hence at most one cycle, and there is one exactly if both roots lie in one such
// stretch: between them the other side is joined (the tube), before and after it is not.
//
// At such a root the slice's zero set is two lines along the other axes, whose roots they give: q
// has both its roots within the cube along all three axes or along none. They are the coordinates
// of a hexagon of lines round the tube (Grosso, Computer Graphics Forum 2016). The discriminant of
// q is Cayley's hyperdeterminant, the same along all axes. (Chernyaev, CERN CN/95-17; Custodio,
// Etiene, Pesco, Silva, Computers and Graphics 2013.)
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/cube/cube.h"
#include "core/grid/grid.h"
#include "core/grid/lattice.h"

namespace isoloop {

/// Value minus iso at corner dx + 2 dy + 4 dz of a cube: not negative inside; finite.
using CornerLevels = std::array<double, 8>;

/// The side whose parts an interior tunnel joins, if both roots of q lie within the cube along all
/// axes. The faces must allow for a tunnel too (tunnel_hub()): with the signs of a checkerboard the
/// roots may lie in different stretches.
///
/// Every sign is that of the exact value. Ties: a saddle at the iso value, on a face or within the
/// cube, counts as outside. So a double root of q is a tunnel of the outside and none of the
/// inside. The rule knows no axis and no direction.
std::optional<Side> interior_tunnel(const CornerLevels& levels);

/// The hub of `cut`'s tunnel, which it has with these levels at its corners, if any. Of two hubs of
/// one side that whose diagonal the tunnel runs along.
std::optional<int> tunnel_hub(const CubeCut& cut, const CornerLevels& levels);

/// How the ambiguous faces of a cube are decided: bit f is face f.
struct DecidedFaces {
  unsigned ambiguous = 0;
  unsigned joined = 0;  // the inside corners of these
};

/// `inside`: as cube_cut() wants it. `level_at(corner)` is asked at ambiguous faces alone.
template <class LevelAt>
DecidedFaces decide_faces(std::uint8_t inside, const LevelAt& level_at) {
  DecidedFaces decided;
  for (int face = 0; face < 6; ++face) {
    const auto ring = face_ring(face);
    unsigned bits = 0;
    for (int i = 0; i < 4; ++i) bits |= (inside >> ring[i] & 1U) << i;
    if (!is_ambiguous(bits)) continue;
    decided.ambiguous |= 1U << face;
    std::array<double, 4> levels{};
    for (int i = 0; i < 4; ++i) levels[i] = level_at(int{ring[i]});
    if (inside_is_joined(levels)) decided.joined |= 1U << face;
  }
  return decided;
}

/// A cube as cube_cut() wants it, and what that gives where its parity is even.
struct DecidedCube {
  std::uint8_t inside = 0;
  std::uint8_t joined = 0;
  const CubeCut* cut = nullptr;
};

/// How M cuts a cube with these levels. `tunnels`: whether those of the interpolant count.
DecidedCube decide_cube(const CornerLevels& levels, bool tunnels);

/// The ring round a tunnel, in shares of the cube's edges: points on the interpolant's iso-surface
/// unless they would come closer than `least_share` to the cube's faces, or than twice that to each
/// other along an axis. Vertex a of it lies towards the hub's neighbour along axis a.
std::array<Vec3, ring_size> tunnel_ring(const CornerLevels& levels, int hub, double least_share);

}  // namespace isoloop
