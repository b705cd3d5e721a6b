#include "volume/vdb.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <utility>
#include <vector>

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>

#include "core/errors.h"
#include "volume/memory_limit.h"

namespace isoloop {
namespace {

constexpr double shear_tolerance = 1e-6;  // cosine between two index axes

openvdb::GridPtrVec read_grids(const std::filesystem::path& path) {
  openvdb::initialize();
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InvalidInput(path.string() + ": cannot be opened; check that you may read it");
  const std::string damaged =
      path.string() + ": not a whole OpenVDB file; fetch or export it again";
  try {
    // OpenVDB does not check its reads: without these exceptions a truncated file is accepted.
    file.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
    openvdb::io::Stream stream(file, /*delayLoad=*/false);
    return *stream.getGrids();
  } catch (const std::ios_base::failure&) {
    throw InvalidInput(damaged + " (it ends too early)");
  } catch (const std::bad_alloc&) {
    throw InvalidInput(damaged + " (it asks for more memory than there is)");
  } catch (const std::exception& error) {
    throw InvalidInput(damaged + " (" + error.what() + ")");
  }
}

bool is_scalar(const openvdb::GridBase& grid) {
  return grid.isType<openvdb::FloatGrid>() || grid.isType<openvdb::DoubleGrid>();
}

/// The grids' names; those that share one become NAME[0], NAME[1], ...
std::vector<std::string> unique_names(const openvdb::GridPtrVec& grids) {
  std::vector<std::string> names;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    const auto same = [&](const auto& grid) { return grid->getName() == grids[g]->getName(); };
    const auto here = grids.begin() + static_cast<std::ptrdiff_t>(g);
    const bool shared = std::count_if(grids.begin(), grids.end(), same) > 1;
    const auto before = std::count_if(grids.begin(), here, same);
    names.push_back(grids[g]->getName() + (shared ? "[" + std::to_string(before) + "]" : ""));
  }
  return names;
}

std::string list_grids(const openvdb::GridPtrVec& grids) {
  const std::vector<std::string> names = unique_names(grids);
  std::string list;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    list += (g == 0 ? "'" : ", '") + names[g] + "' (" + grids[g]->valueType() + ")";
  }
  return list.empty() ? "nothing" : list;
}

openvdb::GridBase::ConstPtr choose_grid(const openvdb::GridPtrVec& grids, const std::string& name,
                                        const std::string& file) {
  const std::vector<std::string> names = unique_names(grids);
  std::vector<openvdb::GridBase::ConstPtr> found;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    const bool named = grids[g]->getName() == name || names[g] == name;
    if (name.empty() ? is_scalar(*grids[g]) : named) found.push_back(grids[g]);
  }
  const std::string held = "; the file holds " + list_grids(grids);
  if (found.empty() && !name.empty()) {
    throw InvalidArgument(file + ": no grid is called '" + name + "'" + held);
  }
  if (found.empty()) throw InvalidInput(file + ": no float or double grid to read" + held);
  if (found.size() > 1) {
    throw InvalidArgument(file + ": several grids fit; choose one with --grid NAME" + held);
  }
  if (!is_scalar(*found.front())) {
    throw InvalidInput(file + ": grid '" + name + "' holds " + found.front()->valueType() +
                       " values; only float and double grids can be read");
  }
  return found.front();
}

/// Sets spacing and direction of `volume`, and its origin to the world position of `corner`.
void set_frame(Volume& volume, const openvdb::math::Transform& transform,
               const openvdb::Coord& corner, const std::string& what) {
  if (!transform.isLinear()) {
    throw InvalidInput(what + " has a perspective transform (" + transform.mapType() +
                       "); resample it to a linear one first");
  }
  const openvdb::Mat4d matrix = transform.baseMap()->getAffineMap()->getMat4();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const openvdb::Vec4d row = matrix.row(static_cast<int>(axis));
    const double length = std::hypot(row[0], row[1], row[2]);
    if (!std::isfinite(length) || length <= 0.0) {
      throw InvalidInput(what + " has a transform that flattens axis " + std::to_string(axis));
    }
    volume.spacing[axis] = length;
    volume.direction[axis] = {row[0] / length, row[1] / length, row[2] / length};
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vec3& a = volume.direction[axis];
    const Vec3& b = volume.direction[(axis + 1) % 3];
    if (std::abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) > shear_tolerance) {
      throw InvalidInput(what + " has a sheared transform: its axes are not at right angles; " +
                         "resample it to an unsheared one first");
    }
  }
  const openvdb::Vec3d origin = transform.indexToWorld(corner);
  volume.origin = {origin[0], origin[1], origin[2]};
  volume.frame = Frame::world;
}

/// The active voxels' box and the margin round it.
openvdb::CoordBBox box_of(const openvdb::GridBase& grid, VdbMargin margin,
                          const std::string& what) {
  const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  if (box.empty()) throw InvalidInput(what + " has no active voxels");
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min()[axis] == std::numeric_limits<openvdb::Int32>::min() ||
        box.max()[axis] == std::numeric_limits<openvdb::Int32>::max()) {
      throw InvalidInput(what + " reaches the end of OpenVDB's index space; crop it first");
    }
  }
  const int layers = margin == VdbMargin::background ? 1 : 0;
  return {box.min().offsetBy(-layers), box.max().offsetBy(layers)};
}

template <class Grid>
VoxelArray densify(const Grid& grid, const openvdb::CoordBBox& box, std::uint64_t count) {
  using Value = typename Grid::ValueType;
  std::vector<Value> values(count);
  openvdb::tools::Dense<Value, openvdb::tools::LayoutXYZ> dense(box, values.data());
  openvdb::tools::copyToDense(grid, dense);
  return values;
}

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
      throw InvalidInput(what + ": OpenVDB cannot hold " + dims_text(volume.dims) + " voxels");
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

Volume read_vdb(const std::filesystem::path& path, const std::string& grid, std::uint64_t max_bytes,
                VdbMargin margin) {
  const openvdb::GridBase::ConstPtr chosen = choose_grid(read_grids(path), grid, path.string());
  const std::string what = path.string() + ": grid '" + chosen->getName() + "'";
  const openvdb::CoordBBox box = box_of(*chosen, margin, what);
  Volume volume;
  set_frame(volume, chosen->transform(), box.min(), what);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int a = static_cast<int>(axis);
    volume.dims[axis] = std::int64_t{box.max()[a]} - box.min()[a] + 1;
  }
  const auto floats = openvdb::gridConstPtrCast<openvdb::FloatGrid>(chosen);
  check_voxel_memory(volume.dims, floats ? sizeof(float) : sizeof(double), max_bytes, what);
  const std::uint64_t count = checked_voxel_count(volume.dims, what);
  volume.values = floats ? densify(*floats, box, count)
                         : densify(static_cast<const openvdb::DoubleGrid&>(*chosen), box, count);
  volume.level_set = chosen->getGridClass() == openvdb::GRID_LEVEL_SET;
  volume.name = chosen->getName();
  return volume;
}

void write_vdb(std::ostream& out, const Volume& volume, const std::string& what) {
  try {
    openvdb::initialize();
    openvdb::io::Stream stream(out);
    stream.setCompression(openvdb::io::COMPRESS_BLOSC | openvdb::io::COMPRESS_ACTIVE_MASK);
    stream.write(openvdb::GridPtrVec{to_grid(volume, what)});
  } catch (const openvdb::Exception& error) {
    throw InvalidInput(what + ": OpenVDB cannot write the volume: " + error.what());
  }
}

}  // namespace isoloop
