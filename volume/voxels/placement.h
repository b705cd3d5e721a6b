// Where a header puts its voxels in the world, and the headers that make no sense.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "isoloop/read.h"
#include "isoloop/volume.h"

namespace isoloop {

/// The map from voxel indices to the world, as a header states it.
struct Placement {
  std::array<Vec3, 3> columns{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};  // along index axis a
  Vec3 origin{0.0, 0.0, 0.0};  // of the centre of voxel (0, 0, 0)
  Frame frame = Frame::index;
};

/// Sets the volume's spacing, direction, origin and frame; with `spacing` given those of a file
/// without a frame. Lengths within 10^-6 of a number of six digits are that number: headers store
/// unit vectors and lengths as float32. Throws InvalidInput, with the readings that are possible,
/// if an axis has no length, a number is not finite, or axes are not at right angles.
void place(Volume& volume, const Placement& placement, const std::optional<Vec3>& spacing,
           const std::string& what);

/// Columns of these lengths along the world's axes. Throws InvalidInput, with both readings, if one
/// is negative, and if one is 0 or not finite.
std::array<Vec3, 3> columns_of(const Vec3& spacing, const std::string& what);

/// Where the placement puts a voxel.
Vec3 to_world(const Placement& placement, const Vec3& index);

/// The largest distance between where two placements put a corner of the volume.
double largest_distance(const Placement& a, const Placement& b, const Index3& dims);

/// The same placement in the other of the frames LPS and RAS, which differ by the signs of the
/// first two coordinates. Throws InvalidArgument if the volume's frame is neither.
void turn_frame(Volume& volume, Frame frame, const std::string& what);

}  // namespace isoloop
