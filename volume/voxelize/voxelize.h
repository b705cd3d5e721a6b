// From a mesh to a level set.
#pragma once

#include <optional>
#include <string>

#include "isoloop/read.h"
#include "isoloop/volume.h"
#include "volume/base/memory_limit.h"
#include "volume/mesh/mesh.h"

namespace isoloop {

/// The mesh's signed distance at the voxel centres, float32, at most three voxels either way;
/// negative inside, 0 on the mesh. The frame is `world`, that of the mesh; level_set is set; two
/// layers of voxels or more surround the mesh.
/// A closed mesh has its inside where it winds round a voxel centre, so that a shell within another
/// that faces the other way bounds a cavity; if its triangles disagree in their orientation, where
/// a ray crosses the mesh an odd number of times; if it is open, where OpenVDB's flood from without
/// does not reach. `warnings` say where more than a closed mesh without overlaps was found. Parts
/// of the solid and gaps in it that are thinner than a voxel may be lost: the mesh's topology is
/// that of the level set where voxels are small enough. Volume::mesh has the mesh's own counts to
/// compare with, its `gap` within one voxel's length; or `counts`, where they are known before.
/// Throws InvalidArgument unless `size` states one positive number, InvalidInput if the mesh is
/// a point or too far from the origin for doubles, and LimitExceeded, before memory is asked for,
/// if the voxels are more than `limits` allow; `what` opens the message of an error.
Volume voxelize(const Mesh& mesh, const VoxelSize& size, const VoxelLimits& limits,
                const std::string& what, const std::optional<MeshCounts>& counts = {});

}  // namespace isoloop
