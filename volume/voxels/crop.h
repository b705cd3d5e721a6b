// Parts of volumes.
#pragma once

#include <string>

#include "isoloop/read.h"
#include "isoloop/volume.h"

namespace isoloop {

/// Voxels from `first` on, `dims` of them along each axis.
struct VoxelBox {
  Index3 first{};
  Index3 dims{};
};

/// The voxels of `box` in a volume of `dims`. Throws InvalidArgument, which opens with `what` and
/// names the dims, unless each range lies within the volume and holds a voxel.
VoxelBox voxels_in(const CropBox& box, const Index3& dims, const std::string& what);

/// The voxels of `box` alone. World coordinates stay: the origin moves to the part's first voxel.
/// Volume::part says which part it is. While it is made, whole and part are both in memory. Throws
/// as voxels_in() does.
Volume crop(Volume volume, const CropBox& box, const std::string& what = "the volume");

/// Makes `volume` the part of itself that `box` is, but for its values.
void place_part(Volume& volume, const VoxelBox& box);

}  // namespace isoloop
