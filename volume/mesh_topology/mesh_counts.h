// Components, tunnels and cavities of the solid that a mesh bounds, from its triangles alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "isoloop/surface.h"
#include "isoloop/volume.h"

namespace isoloop {

struct Mesh;

/// A mesh has counts of its own if each edge has two triangles and no two triangles cross or touch
/// but at the corners and sides that they share: then each of its shells is a closed surface with
/// an inside. Inside is what voxelize() takes: what the shells wind round, or where faces disagree
/// what lies in an odd number of them. A shell with the solid within it bounds a component, one
/// with the solid around it a cavity, and each adds its genus to the tunnels.
/// `near`: how far to look for `gap`, unit of the mesh. Time is near-linear, memory about 120 bytes
/// for each triangle; where that is more than `max_bytes`, nothing is counted.
MeshCounts count_mesh(const Mesh& mesh, double near, std::uint64_t max_bytes);

/// "b0 2, b1 2, b2 0".
std::string betti_text(const Betti& betti);

}  // namespace isoloop
