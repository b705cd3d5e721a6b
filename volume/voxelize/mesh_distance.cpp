#include "volume/voxelize/mesh_distance.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/MeshToVolume.h>

namespace isoloop {
namespace {

using openvdb::FloatGrid;

// The types for which OpenVDB's library holds the code: compiling it takes a minute otherwise.
struct Lists {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
};

Lists lists_of(const Mesh& mesh, const std::vector<Vec3>& index_points) {
  Lists lists;
  lists.points.reserve(index_points.size());
  for (const Vec3& p : index_points) {
    lists.points.emplace_back(static_cast<float>(p[0]), static_cast<float>(p[1]),
                              static_cast<float>(p[2]));
  }
  lists.triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) lists.triangles.emplace_back(t[0], t[1], t[2]);
  return lists;
}

std::vector<float> densify(const FloatGrid& grid, const Index3& dims) {
  std::vector<float> values(static_cast<std::size_t>(dims[0] * dims[1] * dims[2]));
  const openvdb::Coord top(static_cast<openvdb::Int32>(dims[0] - 1),
                           static_cast<openvdb::Int32>(dims[1] - 1),
                           static_cast<openvdb::Int32>(dims[2] - 1));
  openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(
      openvdb::CoordBBox(openvdb::Coord(0), top), values.data());
  openvdb::tools::copyToDense(grid, dense);
  return values;
}

}  // namespace

std::vector<float> unsigned_distances(const Mesh& mesh, const std::vector<Vec3>& index_points,
                                      const Index3& dims) {
  openvdb::initialize();
  const Lists lists = lists_of(mesh, index_points);
  const auto grid = openvdb::tools::meshToUnsignedDistanceField<FloatGrid>(
      *openvdb::math::Transform::createLinearTransform(), lists.points, lists.triangles, {},
      band_voxels);
  return densify(*grid, dims);
}

std::vector<float> flooded_distances(const Mesh& mesh, const std::vector<Vec3>& index_points,
                                     const Index3& dims) {
  openvdb::initialize();
  const Lists lists = lists_of(mesh, index_points);
  const auto grid = openvdb::tools::meshToSignedDistanceField<FloatGrid>(
      *openvdb::math::Transform::createLinearTransform(), lists.points, lists.triangles, {},
      band_voxels, band_voxels);
  return densify(*grid, dims);
}

}  // namespace isoloop
