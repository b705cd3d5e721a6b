// OpenVDB files: one scalar grid, densified over its active voxels.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "isoloop/read.h"
#include "isoloop/volume.h"
#include "volume/base/memory_limit.h"

namespace isoloop {

/// Reads the float or double grid called `grid`; if that is empty, the only one in the file. Grids
/// that share a name are called NAME[0], NAME[1], ... in the order of the file.
/// The volume spans the box of the grid's active voxels and the margin round it; inactive voxels
/// keep their values. Its frame is `world`, its origin the world position of the box's lowest
/// corner; level_set is set for grids of that class. NaN passes. Throws InvalidArgument (several
/// grids fit, or none has that name), LimitExceeded (the box's voxels are more than the limits
/// allow), and InvalidInput: a damaged or truncated file, a grid of another type, without active
/// voxels, or with a sheared or perspective transform.
Volume read_vdb(const std::filesystem::path& path, const std::string& grid,
                const VoxelLimits& limits = {}, VdbMargin margin = VdbMargin::background);

/// Writes one float grid with the volume's name, class and transform, blosc-compressed. Values
/// become float32: integers above 2^24 and doubles are rounded. The background is the largest
/// value of a level set, else the smallest; voxels equal to it are inactive.
/// Throws InvalidInput, opening with `what`, if OpenVDB cannot hold the volume (an axis of 2^31
/// voxels or more, a transform without inverse). A failure to write shows in the stream's state.
void write_vdb(std::ostream& out, const Volume& volume, const std::string& what);

}  // namespace isoloop
