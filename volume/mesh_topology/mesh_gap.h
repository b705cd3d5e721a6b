// How near the shells of a mesh come to each other.
#pragma once

#include <optional>

#include "volume/mesh/mesh.h"
#include "volume/mesh_topology/mesh_shells.h"
#include "volume/mesh_topology/mesh_tree.h"

namespace isoloop {

/// The least distance from a corner of one shell to a triangle of another, unit of the mesh;
/// nothing if it is `near` or more. The same for any number of threads.
std::optional<double> least_gap(const Mesh& mesh, const Shells& shells, const MeshTree& tree,
                                double near);

}  // namespace isoloop
