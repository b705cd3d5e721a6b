#include "volume/vdb/vdb_decode.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <new>
#include <stdexcept>
#include <vector>

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>

#include "core/base/errors.h"
#include "core/grid/vec3.h"
#include "volume/base/refuse.h"
#include "volume/vdb/vdb_message.h"

namespace isoloop {
namespace {

constexpr double shear_tolerance = 1e-6;  // cosine between two index axes

openvdb::GridPtrVec read_grids(std::istream& file, const std::string& what) {
  openvdb::initialize();
  const std::string damaged = "not a whole OpenVDB file; fetch or export it again";
  try {
    // OpenVDB does not check its reads: without these exceptions a truncated file is accepted.
    file.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
    openvdb::io::Stream stream(file, /*delayLoad=*/false);
    return *stream.getGrids();
  } catch (const std::ios_base::failure&) {
    refuse(what, damaged + " (it ends too early)");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::length_error&) {
    throw std::bad_alloc();
  } catch (const std::exception& error) {
    refuse(what, damaged + " (" + error.what() + ")");
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
    std::string name = grids[g]->getName();
    if (shared) name.append("[").append(std::to_string(before)).append("]");
    names.push_back(std::move(name));
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

[[noreturn]] void refuse_grid(Finding grid, const std::string& complaint,
                              Fault fault = Fault::damaged) {
  grid.text = complaint;
  throw InvalidInput(grid, fault);
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
    throw InvalidArgument({.file = file,
                           .text = "no grid is called '" + name + "'" + held,
                           .advice = {Advice::choose_grid}},
                          Option::grid);
  }
  if (found.empty())
    throw InvalidInput({.file = file, .text = "no float or double grid to read" + held},
                       Fault::unsupported);
  if (found.size() > 1) {
    throw InvalidArgument(
        {.file = file, .text = "several grids fit" + held, .advice = {Advice::choose_grid}},
        Option::grid);
  }
  if (!is_scalar(*found.front())) {
    refuse_grid(
        {.file = file, .place = "grid '" + name + "'"},
        "holds " + found.front()->valueType() + " values; only float and double grids can be read",
        Fault::unsupported);
  }
  return found.front();
}

/// Sets spacing and direction of `volume`, and its origin to the world position of `corner`.
void set_frame(Volume& volume, const openvdb::math::Transform& transform,
               const openvdb::Coord& corner, const Finding& grid) {
  if (!transform.isLinear()) {
    refuse_grid(grid,
                std::string("has a perspective transform (") + transform.mapType() +
                    "); resample it to a linear one first",
                Fault::unsupported);
  }
  const openvdb::Mat4d matrix = transform.baseMap()->getAffineMap()->getMat4();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const openvdb::Vec4d row = matrix.row(static_cast<int>(axis));
    const double length = std::hypot(row[0], row[1], row[2]);
    if (!is_spacing(length)) {
      refuse_grid(grid, "has a transform that flattens axis " + std::to_string(axis) +
                            " or blows it up: voxels must be between 1e-18 and 1e18 long");
    }
    volume.spacing[axis] = length;
    volume.direction[axis] = {row[0] / length, row[1] / length, row[2] / length};
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double cosine = dot(volume.direction[axis], volume.direction[(axis + 1) % 3]);
    if (std::abs(cosine) > shear_tolerance) {
      refuse_grid(grid,
                  "has a sheared transform: its axes are not at right angles; resample it to an "
                  "unsheared one first",
                  Fault::unsupported);
    }
  }
  const openvdb::Vec3d origin = transform.indexToWorld(corner);
  volume.origin = {origin[0], origin[1], origin[2]};
  volume.frame = Frame::world;
}

/// The active voxels' box and the margin round it.
openvdb::CoordBBox box_of(const openvdb::GridBase& grid, VdbMargin margin, const Finding& where) {
  const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  if (box.empty()) refuse_grid(where, "has no active voxels");
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min()[axis] == std::numeric_limits<openvdb::Int32>::min() ||
        box.max()[axis] == std::numeric_limits<openvdb::Int32>::max()) {
      refuse_grid(where, "reaches the end of OpenVDB's index space; crop it first");
    }
  }
  const int layers = margin == VdbMargin::background ? 1 : 0;
  return {box.min().offsetBy(-layers), box.max().offsetBy(layers)};
}

Index3 minus(const openvdb::Coord& a, const openvdb::Coord& b) {
  return {std::int64_t{a[0]} - b[0], std::int64_t{a[1]} - b[1], std::int64_t{a[2]} - b[2]};
}

template <class Grid>
void send_blocks(const Grid& grid, const openvdb::CoordBBox& box, std::ostream& out) {
  using Value = typename Grid::ValueType;
  const Value background = grid.background();
  auto tile = grid.tree().cbeginValueAll();
  tile.setMaxDepth(Grid::TreeType::ValueAllCIter::LEAF_DEPTH - 1);
  for (; tile; ++tile) {
    if (*tile == background) continue;
    openvdb::CoordBBox part;
    tile.getBoundingBox(part);
    part.intersect(box);
    if (part.empty()) continue;
    send_tile<Value>(out, minus(part.min(), box.min()), minus(part.max(), box.min()), *tile);
  }
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf) {
    if (!box.hasOverlap(leaf->getNodeBoundingBox())) continue;
    static_assert(Grid::TreeType::LeafNodeType::SIZE == leaf_voxels);
    const std::span<const Value, leaf_voxels> values(leaf->buffer().data(), leaf_voxels);
    send_leaf<Value>(out, minus(leaf->origin(), box.min()), values);
  }
}

}  // namespace

void decode_vdb(std::istream& file, const VdbRequest& request, const std::string& what,
                std::ostream& out) {
  const openvdb::GridBase::ConstPtr chosen =
      choose_grid(read_grids(file, what), request.grid, what);
  const Finding grid{.file = what, .place = "grid '" + chosen->getName() + "'"};
  const openvdb::CoordBBox box = box_of(*chosen, request.margin, grid);
  VdbHeader header;
  set_frame(header.volume, chosen->transform(), box.min(), grid);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int a = static_cast<int>(axis);
    header.volume.dims[axis] = std::int64_t{box.max()[a]} - box.min()[a] + 1;
  }
  header.volume.level_set = chosen->getGridClass() == openvdb::GRID_LEVEL_SET;
  header.volume.name = chosen->getName();
  const auto floats = openvdb::gridConstPtrCast<openvdb::FloatGrid>(chosen);
  const auto doubles = openvdb::gridConstPtrCast<openvdb::DoubleGrid>(chosen);
  header.type = floats ? VoxelType::float32 : VoxelType::float64;
  header.background = floats ? floats->background() : doubles->background();
  send_header(out, header);
  if (floats) {
    send_blocks(*floats, box, out);
  } else {
    send_blocks(*doubles, box, out);
  }
  send_end(out);
}

}  // namespace isoloop
