#include <algorithm>
#include <limits>
#include <vector>

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>

#include "core/base/errors.h"
#include "volume/base/memory_limit.h"
#include "volume/vdb/vdb.h"

namespace isoloop {
namespace {

std::vector<float> float_values(const VoxelArray& values) {
  return std::visit(
      []<class T>(const std::vector<T>& stored) {
        std::vector<float> floats(stored.size());
        std::transform(stored.begin(), stored.end(), floats.begin(),
                       [](T value) { return static_cast<float>(value); });
        return floats;
      },
      values);
}

openvdb::math::Transform::Ptr transform_of(const Volume& volume) {
  openvdb::Mat4d matrix = openvdb::Mat4d::identity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t c = 0; c < 3; ++c) {
      matrix(static_cast<int>(axis), static_cast<int>(c)) =
          volume.spacing[axis] * volume.direction[axis][c];
    }
    matrix(3, static_cast<int>(axis)) = volume.origin[axis];
  }
  return openvdb::math::Transform::createLinearTransform(matrix);
}

openvdb::FloatGrid::Ptr to_grid(const Volume& volume, const std::string& what) {
  openvdb::Coord top;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (volume.dims[axis] > std::numeric_limits<openvdb::Int32>::max()) {
      throw InvalidInput(
          {.file = what, .text = "OpenVDB cannot hold " + dims_text(volume.dims) + " voxels"});
    }
    top[static_cast<int>(axis)] = static_cast<openvdb::Int32>(volume.dims[axis] - 1);
  }
  const ValueRange range = value_range(volume);
  const auto background = static_cast<float>(volume.level_set ? range.max : range.min);
  auto grid = openvdb::FloatGrid::create(background);
  std::vector<float> values = float_values(volume.values);
  const openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(
      openvdb::CoordBBox(openvdb::Coord(0), top), values.data());
  openvdb::tools::copyFromDense(dense, *grid, /*tolerance=*/0.0F);
  grid->setTransform(transform_of(volume));
  grid->setGridClass(volume.level_set ? openvdb::GRID_LEVEL_SET : openvdb::GRID_FOG_VOLUME);
  const char* const usual_name = volume.level_set ? "surface" : "density";
  grid->setName(volume.name.empty() ? usual_name : volume.name);
  return grid;
}

}  // namespace

void write_vdb(std::ostream& out, const Volume& volume, const std::string& what) {
  try {
    openvdb::initialize();
    openvdb::io::Stream stream(out);
    stream.setCompression(openvdb::io::COMPRESS_BLOSC | openvdb::io::COMPRESS_ACTIVE_MASK);
    stream.write(openvdb::GridPtrVec{to_grid(volume, what)});
  } catch (const openvdb::Exception& error) {
    throw InvalidInput(
        {.file = what, .text = std::string("OpenVDB cannot write the volume: ") + error.what()});
  }
}

}  // namespace isoloop
