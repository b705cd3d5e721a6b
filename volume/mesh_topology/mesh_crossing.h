// Whether a mesh crosses or touches itself.
#pragma once

#include <cstddef>
#include <optional>

#include "volume/mesh/mesh.h"
#include "volume/mesh_topology/mesh_tree.h"

namespace isoloop {

/// On which side of the plane of a, b and c, seen anticlockwise from 1, d lies: 1, -1, or 0 where
/// doubles cannot tell.
int side_of_plane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Seen along an axis, with the other two in cyclic order: 1 if a, b, c turn anticlockwise, -1 if
/// clockwise, 0 where doubles cannot tell.
int turn(const Vec3& a, const Vec3& b, const Vec3& c, std::size_t axis);

/// Whether two triangles have a point in common besides shared corners and a shared side. True also
/// where doubles cannot tell; false for a triangle without area, whose sides its neighbours have.
bool triangles_meet(const Mesh& mesh, std::size_t one, std::size_t other);

/// How many pairs of triangles meet; 0 proves that the mesh neither crosses nor touches itself.
/// Nothing if the boxes of so many pairs overlap that looking would take more than near-linear time
/// (200 for each triangle, and 20 million). The same for any number of threads.
std::optional<std::size_t> meeting_pairs(const Mesh& mesh, const MeshTree& tree);

}  // namespace isoloop
