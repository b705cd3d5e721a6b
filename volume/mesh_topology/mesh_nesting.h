// Which shells of a mesh lie within which.
#pragma once

#include <optional>
#include <vector>

#include "volume/mesh/mesh.h"
#include "volume/mesh_topology/mesh_shells.h"
#include "volume/mesh_topology/mesh_tree.h"

namespace isoloop {

/// How often a mesh winds round points next to a shell: on its unbounded side, and within it. Where
/// triangles of the mesh disagree in their orientation, the same modulo 2.
struct WindingAt {
  int around = 0;
  int within = 0;
};

/// For each shell. The shells must neither cross nor touch. Nothing where doubles cannot tell on
/// which side of a triangle a point of another lies.
/// A ray along x from a point of each shell crosses the others: time is that of as many look-ups.
std::optional<std::vector<WindingAt>> windings_at(const Mesh& mesh, const Shells& shells,
                                                  const MeshTree& tree);

}  // namespace isoloop
