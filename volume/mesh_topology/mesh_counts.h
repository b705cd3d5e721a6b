// Components, tunnels and cavities of the solid that a mesh bounds, from its triangles alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/surface/betti.h"

namespace isoloop {

struct Mesh;

/// What a mesh says of its solid before any voxel is.
struct MeshCounts {
  std::size_t triangles = 0;
  std::size_t shells = 0;        // closed surfaces that it consists of; 0 unless `betti` is set
  std::size_t swallowed = 0;     // shells with solid on both their sides: they bound nothing
  std::optional<Betti> betti{};  // of the solid, exactly
  std::string unknown{};         // why `betti` is unset, as in "it is open"; else empty
  /// From a corner of one shell to a triangle of another, unit of the mesh; unset: farther than was
  /// looked, or one shell. Where edges pass each other shells may be nearer still.
  std::optional<double> gap{};
  std::optional<Betti> voxels{};  // where --resolution auto has counted them: those of the volume
};

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
