#include "volume/voxels/placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/errors.h"
#include "core/grid/vec3.h"
#include "volume/base/refuse.h"
#include "volume/base/rounded_text.h"

namespace isoloop {
namespace {

constexpr double shear_tolerance = 1e-3;  // cosine between two index axes
constexpr std::array<char, 3> axis_names{'x', 'y', 'z'};

// Six digits, if that is all that rounding to float32 can have moved.
double rounded_length(double length) {
  const double rounded = std::strtod(rounded_text(length).c_str(), nullptr);
  return std::abs(rounded - length) <= 1e-6 * length ? rounded : length;
}

/// Throws, of a header that places no voxels.
[[noreturn]] void refuse_placement(const std::string& what, const std::string& complaint) {
  refuse(what, complaint, Fault::damaged, {Advice::correct_header, Advice::state_spacing});
}

void check_right_angles(const Volume& volume, const std::string& what) {
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const double cosine = dot(volume.direction[a], volume.direction[b]);
    if (std::abs(cosine) <= shear_tolerance) continue;
    const double degrees = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
    refuse(what,
           std::string("its axes ") + axis_names[a] + " and " + axis_names[b] + " meet at " +
               rounded_text(degrees) + " degrees (sheared); read as a box of voxels " +
               rounded_text(volume.spacing[0]) + " x " + rounded_text(volume.spacing[1]) + " x " +
               rounded_text(volume.spacing[2]) + ", lengths would be wrong by up to " +
               rounded_text(100 * std::abs(cosine)) + " %",
           Fault::unsupported, {Advice::resample, Advice::state_spacing});
  }
}

}  // namespace

void place(Volume& volume, const Placement& placement, const std::optional<Vec3>& spacing,
           const std::string& what) {
  if (spacing) {
    volume.spacing = *spacing;
    return;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vec3& column = placement.columns[axis];
    const double length = std::hypot(column[0], column[1], column[2]);
    if (!is_spacing(length)) {
      refuse_placement(what, "its header states the spacing " + rounded_text(length) + " along " +
                                 axis_names[axis] + ", which is not between 1e-18 and 1e18");
    }
    if (!std::isfinite(placement.origin[axis])) {
      refuse_placement(what, "its header states an origin that is not finite");
    }
    volume.spacing[axis] = rounded_length(length);
    for (std::size_t c = 0; c < 3; ++c) volume.direction[axis][c] = column[c] / length;
  }
  volume.origin = placement.origin;
  volume.frame = placement.frame;
  check_right_angles(volume, what);
}

std::array<Vec3, 3> columns_of(const Vec3& spacing, const std::string& what) {
  std::array<Vec3, 3> columns{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double length = spacing[axis];
    const std::string stated =
        "its header states the spacing " + rounded_text(length) + " along " + axis_names[axis];
    if (length < 0.0) {
      refuse_placement(what, stated + ", which may mean a length of " + rounded_text(-length) +
                                 " or an axis that runs backwards, and isoloop does not guess");
    }
    if (!std::isfinite(length) || length == 0.0) refuse_placement(what, stated);
    columns[axis][axis] = length;
  }
  return columns;
}

Vec3 to_world(const Placement& placement, const Vec3& index) {
  Vec3 world = placement.origin;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t c = 0; c < 3; ++c) world[c] += index[axis] * placement.columns[axis][c];
  }
  return world;
}

double largest_distance(const Placement& a, const Placement& b, const Index3& dims) {
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      index[axis] = (corner >> axis & 1) != 0 ? static_cast<double>(dims[axis] - 1) : 0.0;
    }
    const double apart = distance(to_world(a, index), to_world(b, index));
    if (std::isnan(apart)) return apart;
    largest = std::max(largest, apart);
  }
  return largest;
}

void turn_frame(Volume& volume, Frame frame, const std::string& what) {
  if (volume.frame == frame) return;
  if (volume.frame != Frame::lps && volume.frame != Frame::ras) {
    throw InvalidArgument(
        {.file = what,
         .about = Option::world,
         .text = "cannot be taken: the file does not say where left and right are"});
  }
  for (std::size_t c = 0; c < 2; ++c) {
    volume.origin[c] = 0.0 - volume.origin[c];
    for (Vec3& axis : volume.direction) axis[c] = 0.0 - axis[c];
  }
  volume.frame = frame;
}

}  // namespace isoloop
