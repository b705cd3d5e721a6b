// Corners of triangles that are one point but for their last bits.
#pragma once

#include <string>

#include "volume/mesh/mesh.h"

namespace isoloop {

/// Corners no farther apart than this share of the diagonal of the mesh's box may be one: 16 times
/// the step of the 32-bit numbers that most mesh files hold.
inline constexpr double weld_share = 1e-6;

/// Points of equal coordinates become the first of them, and triangles that use one twice are left
/// out; points that are in no triangle stay.
Mesh weld_equal_points(Mesh mesh);

/// Joins each point of an open edge to the first point of an open edge that lies within weld_share,
/// and says so in Mesh::warnings. The mesh stays as it is if that closes no edge, and so does any
/// point where two corners of a triangle would become one: a closed mesh never changes, and no
/// triangle is lost. Points are taken in their order, and one that was joined draws no others
/// along, so nothing moves by more than the tolerance. Time is linear but for sorting.
/// `what` opens the warning.
Mesh weld_borders(Mesh mesh, const std::string& what);

}  // namespace isoloop
