#include "volume/voxelize/voxelize.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/errors.h"
#include "volume/base/rounded_text.h"
#include "volume/mesh/mesh_box.h"
#include "volume/mesh/mesh_closure.h"
#include "volume/mesh_topology/mesh_counts.h"
#include "volume/voxelize/mesh_distance.h"
#include "volume/voxelize/mesh_winding.h"

namespace isoloop {
namespace {

// Around the mesh. The half keeps the faces of an upright box away from voxel centres.
constexpr double margin = 2.5;

double longest_side(const Box& box) {
  return std::max({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
}

double voxel_length(const Box& box, const VoxelSize& size, const std::string& what) {
  const double side = longest_side(box);
  constexpr double most_side = 1e100;  // far from where sums and products overflow
  if (!(side > 0.0 && side < most_side)) {
    throw InvalidInput({.file = what, .text = "the mesh has no extent that could be voxelised"});
  }
  if (size.length && (size.resolution || size.automatic)) {
    throw InvalidArgument({.file = what,
                           .text = "a mesh takes one size of voxels, not two",
                           .advice = {Advice::state_voxel_size}},
                          Option::voxel_size);
  }
  if (size.automatic || size.length.has_value() == size.resolution.has_value()) {
    throw InvalidArgument(
        {.file = what,
         .text = "a mesh needs a voxel size; its longest side is " + rounded_text(side),
         .advice = {Advice::state_voxel_size}},
        Option::voxel_size);
  }
  const double length = size.length ? *size.length : side / static_cast<double>(*size.resolution);
  if (!is_spacing(length)) {
    throw InvalidArgument({.file = what,
                           .about = Option::voxel_size,
                           .text = "must be positive, and voxels between 1e-18 and 1e18 long"});
  }
  return length;
}

void check_distance(const Box& box, double length, const std::string& what) {
  constexpr double most_voxels = 1e12;  // from the origin; beyond, doubles blur a voxel's parts
  for (std::size_t a = 0; a < 3; ++a) {
    const double distance = std::max(std::abs(box.low[a]), std::abs(box.high[a]));
    if (distance / length < most_voxels) continue;
    throw InvalidInput({.file = what,
                        .text = "the mesh lies so far from the origin (" + rounded_text(distance) +
                                ") that voxels of " + rounded_text(length) +
                                " cannot be told apart; move it to the origin"});
  }
}

Index3 dims_of(const Box& box, double length, const std::string& what) {
  Index3 dims{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double voxels = std::ceil((box.high[a] - box.low[a]) / length + 2.0 * margin) + 1.0;
    constexpr double most = 1e9;
    if (!(voxels < most)) {
      throw LimitExceeded(
          {.file = what,
           .text = "voxels of " + rounded_text(length) + " are more than can be counted",
           .advice = {Advice::take_larger_voxels}},
          {.unit = Excess::Unit::voxels});
    }
    dims[a] = static_cast<std::int64_t>(voxels);
  }
  return dims;
}

std::vector<Vec3> index_points(const Mesh& mesh, const Vec3& origin, double length) {
  std::vector<Vec3> points(mesh.points.size());
  // Points that no triangle uses may lie anywhere; they stay at the origin.
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      for (std::size_t a = 0; a < 3; ++a) {
        points[corner][a] = (mesh.points[corner][a] - origin[a]) / length;
      }
    }
  }
  return points;
}

/// Signed distances in voxels, and what had to be assumed.
std::vector<float> signed_distances(const Mesh& mesh, const std::vector<Vec3>& points,
                                    const Index3& dims, std::uint64_t max_bytes,
                                    const std::string& what, std::vector<Finding>& warnings) {
  const Closure closure = closure_of(mesh);
  if (closure.open_edges > 0) {
    warnings.push_back(
        {.file = what,
         .text = "the mesh is open (" + std::to_string(closure.open_edges) +
                 " edges do not have an even number of faces); inside is taken to be what cannot "
                 "be reached "
                 "from without through a hole wider than a voxel, so hollows are filled"});
    return flooded_distances(mesh, points, dims);
  }
  std::vector<float> values = unsigned_distances(mesh, points, dims);
  const InsideOf rule = closure.one_way_edges > 0 ? InsideOf::parity : InsideOf::winding;
  const WindingResult result = negate_inside(values, dims, mesh, points, rule, max_bytes, what);
  if (rule == InsideOf::parity) {
    warnings.push_back(
        {.file = what,
         .text = "faces disagree on which side is outside (" +
                 std::to_string(closure.one_way_edges) +
                 " edges); inside is taken to be where a line from without has crossed the "
                 "mesh an odd number of times"});
  } else if (result.twice || result.opposite) {
    warnings.push_back(
        {.file = what,
         .text =
             std::string("the mesh crosses itself or has parts that overlap; inside is taken to "
                         "be all that it winds round") +
             (result.opposite ? ", in either direction" : "")});
  }
  return values;
}

}  // namespace

Volume voxelize(const Mesh& mesh, const VoxelSize& size, const VoxelLimits& limits,
                const std::string& what, const std::optional<MeshCounts>& counts) {
  const Box box = box_of(mesh);
  const double length = voxel_length(box, size, what);
  Volume volume;
  volume.dims = dims_of(box, length, what);
  check_voxel_memory(volume.dims, sizeof(float), limits, what);
  check_distance(box, length, what);
  const std::uint64_t max_bytes = limits.max_bytes == 0 ? default_voxel_limit() : limits.max_bytes;
  volume.spacing = {length, length, length};
  for (std::size_t a = 0; a < 3; ++a) volume.origin[a] = box.low[a] - margin * length;
  volume.frame = Frame::world;
  volume.level_set = true;
  volume.warnings = mesh.warnings;
  if (mesh.loose_points > 0) {
    volume.warnings.push_back(
        {.file = what,
         .text = std::to_string(mesh.loose_points) +
                 " points are in no face; the mesh is taken to be whole, but if the "
                 "file was cut short, parts of it are missing"});
  }
  volume.mesh = counts ? *counts : count_mesh(mesh, length, max_bytes);
  const std::vector<Vec3> points = index_points(mesh, volume.origin, length);
  std::vector<float> values =
      signed_distances(mesh, points, volume.dims, max_bytes, what, volume.warnings);
  const auto scale = static_cast<float>(length);
  for (float& value : values) value *= scale;
  volume.values = std::move(values);
  return volume;
}

}  // namespace isoloop
