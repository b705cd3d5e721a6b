// The octree of a prepared volume, and the complexes of both sides within it.
#pragma once

#include <array>
#include <cstdint>

#include "core/complex/octree_complex.h"
#include "core/complex/octree_sizes.h"
#include "core/octree/leaves.h"
#include "core/octree/octree.h"
#include "tests/samples/core_fixture.h"

namespace isoloop::testing {

/// Owns what OctreeComplex refers to; not to be moved. The surface must not be empty.
struct PreparedOctree {
  PreparedOctree(const Prepared& from, int grading, GeodesicMode mode = GeodesicMode::exact)
      : prepared(from),
        leaves(graded_leaves(from.sides, from.surface.spacing, grading)),
        octree(from.sides, leaves),
        inside(octree, *from.inside),
        outside(octree, *from.outside),
        sizes(octree_edge_sizes(octree, from.edges, from.surface,
                                closest_surface_vertices(octree, from.surface), mode)) {}
  PreparedOctree(const PreparedOctree&) = delete;
  PreparedOctree& operator=(const PreparedOctree&) = delete;

  const OctreeComplex& complex(Side side) const { return side == Side::inside ? inside : outside; }
  OctreeSizes sizes_on(Side side) const { return {complex(side), prepared.edges, sizes}; }

  const Prepared& prepared;
  Leaves leaves;
  Octree octree;
  OctreeComplex inside;
  OctreeComplex outside;
  OctreeEdgeSizes sizes;
};

/// Noise or a shape amid room for leaves of many levels: solid room, or empty room between two far
/// voxels.
inline SmallVolume with_room(std::uint32_t seed) {
  const SmallVolume core = seed % 3 == 0   ? smooth_noise({6, 7, 5}, seed, 1)
                           : seed % 3 == 1 ? white_noise({4, 5, 4}, seed)
                                           : torus({14, 14, 9});
  const bool is_solid = seed % 2 == 0;
  const auto pad = static_cast<std::int64_t>(4 + seed / 6 % 9);
  const auto scale = static_cast<std::int64_t>(seed % 3 == 2 ? 1 : 1 + seed / 2 % 2);
  Index3 dims{};
  for (std::size_t a = 0; a < 3; ++a) dims[a] = core.dims[a] * scale + 2 * pad;
  SmallVolume volume = sampled(dims, [&](double x, double y, double z) {
    const std::array<double, 3> at{x, y, z};
    std::int64_t voxel = 0;
    for (const std::size_t a : {2U, 1U, 0U}) {
      const std::int64_t i = static_cast<std::int64_t>(at[a]) - pad;
      if (i < 0 || i >= core.dims[a] * scale) return is_solid ? 1.0 : -1.0;
      voxel = voxel * core.dims[a] + i / scale;
    }
    const double here = core.values[static_cast<std::size_t>(voxel)];
    return is_solid ? -here : here;
  });
  volume.values.front() = 1.0;
  volume.values.back() = 1.0;
  return volume;
}

}  // namespace isoloop::testing
