#include "volume/voxels/crop.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "volume/base/memory_limit.h"

namespace isoloop {
namespace {

constexpr std::array<char, 3> axis_names{'x', 'y', 'z'};

std::string text(const CropRange& range) {
  return (range.begin ? std::to_string(*range.begin) : "") + ":" +
         (range.end ? std::to_string(*range.end) : "");
}

template <class T>
std::vector<T> values_in(const std::vector<T>& values, const Index3& dims, const VoxelBox& box) {
  std::vector<T> part;
  part.reserve(static_cast<std::size_t>(box.dims[0] * box.dims[1] * box.dims[2]));
  for (std::int64_t z = box.first[2]; z < box.first[2] + box.dims[2]; ++z) {
    for (std::int64_t y = box.first[1]; y < box.first[1] + box.dims[1]; ++y) {
      const auto row = values.begin() + box.first[0] + dims[0] * (y + dims[1] * z);
      part.insert(part.end(), row, row + box.dims[0]);
    }
  }
  return part;
}

}  // namespace

VoxelBox voxels_in(const CropBox& box, const Index3& dims, const std::string& what) {
  VoxelBox voxels;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t begin = box[axis].begin.value_or(0);
    const std::int64_t end = box[axis].end.value_or(dims[axis]);
    const std::string asked =
        "asks for the voxels " + text(box[axis]) + " along " + axis_names[axis] + ", ";
    if (begin < 0 || begin >= dims[axis] || end > dims[axis]) {
      throw InvalidArgument({.file = what,
                             .about = Option::crop,
                             .text = asked + "but there are 0:" + std::to_string(dims[axis]) +
                                     " in " + dims_text(dims) + " voxels"});
    }
    if (begin >= end) {
      throw InvalidArgument(
          {.file = what,
           .about = Option::crop,
           .text = asked + "which are none, since the second number is the first that is " +
                   "left out; there are " + dims_text(dims) + " voxels"});
    }
    voxels.first[axis] = begin;
    voxels.dims[axis] = end - begin;
  }
  return voxels;
}

void place_part(Volume& volume, const VoxelBox& box) {
  Vec3 first{};
  std::copy(box.first.begin(), box.first.end(), first.begin());
  volume.origin = to_world(volume, first);
  volume.part = VolumePart{.first = box.first, .whole = volume.dims};
  volume.dims = box.dims;
  volume.stored_at.reset();
}

Volume crop(Volume volume, const CropBox& box, const std::string& what) {
  const VoxelBox voxels = voxels_in(box, volume.dims, what);
  volume.values = std::visit(
      [&](const auto& values) -> VoxelArray { return values_in(values, volume.dims, voxels); },
      volume.values);
  place_part(volume, voxels);
  return volume;
}

}  // namespace isoloop
