// Label maps: voxels that name what they belong to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "volume/volume.h"

namespace isoloop {

/// The volume as a mask: uint8 voxels, 1 where the value is one of `labels`, else 0. A warning
/// names labels that no voxel has. Throws InvalidArgument if no voxel has any of them, listing
/// labels that there are.
Volume mask_of_labels(Volume volume, const std::vector<std::int64_t>& labels,
                      const std::string& what);

}  // namespace isoloop
