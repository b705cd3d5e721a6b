// How often a mesh winds round each voxel centre: exact signs for a solid, cavities included.
#pragma once

#include <cstdint>
#include <vector>

#include "volume/mesh/mesh.h"

namespace isoloop {

/// What counts as inside: a winding number other than 0, or an odd number of crossings.
enum class InsideOf { winding, parity };

struct WindingResult {
  bool twice = false;     // it winds round some voxel twice or more: parts overlap
  bool opposite = false;  // round some voxels one way and round others the other way
};

/// Negates the values of all voxels that lie inside. `index_points` are the mesh's points in voxel
/// indices, each within dims; they are moved by up to 1/8192 of a voxel, all triangles at a point
/// alike, so that every test is exact in integers and each row of voxels crosses a closed mesh in
/// and out equally often (a voxel centre on a triangle's edge belongs to one side by a rule).
/// The mesh must be closed: in integers for `winding`, modulo 2 for `parity`. Throws LimitExceeded
/// if dims exceed 2^18 or the lists of triangles take more than `max_bytes`; `what` opens the
/// message.
/// Source: scan conversion by Kaufman and Shimony (1986); ties as Edelsbrunner and Mücke (1990).
WindingResult negate_inside(std::vector<float>& values, const Index3& dims, const Mesh& mesh,
                            const std::vector<Vec3>& index_points, InsideOf rule,
                            std::uint64_t max_bytes, const std::string& what);

}  // namespace isoloop
