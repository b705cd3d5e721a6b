// Distances from voxel centres to a mesh, by OpenVDB.
#pragma once

#include <vector>

#include "volume/mesh/mesh.h"

namespace isoloop {

constexpr float band_voxels = 3.0F;  // on each side of the mesh; distances beyond are this

/// Distances, in voxels, from the voxel centres of a grid of `dims` to the mesh, whose points are
/// given in voxel indices; at most band_voxels. The first axis is fastest.
std::vector<float> unsigned_distances(const Mesh& mesh, const std::vector<Vec3>& index_points,
                                      const Index3& dims);

/// The same, negative at voxels that cannot be reached from the border of the grid without
/// crossing the mesh, where a hole that is narrower than a voxel is none.
std::vector<float> flooded_distances(const Mesh& mesh, const std::vector<Vec3>& index_points,
                                     const Index3& dims);

}  // namespace isoloop
