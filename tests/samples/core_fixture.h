// The pipeline up to one side's complex, for tests of what comes after.
#pragma once

#include <memory>
#include <vector>

#include "core/complex/grid_complex.h"
#include "core/complex/grid_sizes.h"
#include "core/cube/voxel_sides.h"
#include "core/engines/dual_pass.h"
#include "core/sizes/closest.h"
#include "core/sizes/geodesic_size.h"
#include "core/surface/edge_index.h"
#include "core/surface/surface.h"
#include "tests/oracles/explicit_complex.h"
#include "tests/oracles/random_volumes.h"

namespace isoloop::testing {

inline constexpr IsoLevel zero_level{0.0, InsideRule::above};

/// The walls that core/ builds, for the complex written out in `box`, which holds that of `sides`.
inline oracle::Walls walls_of(const VoxelSides& sides, const Lattice& box) {
  oracle::Walls walls;
  for (const VoxelSides::Tunnel& tunnel : sides.tunnels) {
    auto p = sides.lattice.position(tunnel.cube);
    for (int a = 0; a < 3; ++a)
      p[a] += static_cast<std::uint32_t>(sides.lattice.first[a] - box.first[a]);
    const std::uint32_t cube = box.vertex(p[0], p[1], p[2]);
    for (const std::uint8_t edge : cut_at(sides, tunnel).wall.edges)
      walls[cube].push_back(lattice_edge(box, cube, edge));
  }
  return walls;
}

inline oracle::Walls walls_of(const VoxelSides& sides) { return walls_of(sides, sides.lattice); }

/// Owns what GridComplex refers to; not to be moved.
struct Prepared {
  explicit Prepared(const SmallVolume& from, GeodesicMode mode = GeodesicMode::exact,
                    Boundary boundary = Boundary::closed)
      : volume(from),
        sides(classify(volume.view(), zero_level, boundary)),
        edges(sides),
        surface(extract_surface(volume.view(), zero_level, sides, edges)) {
    if (surface.points.empty()) return;
    closest = closest_surface_vertices(sides, edges, surface);
    sizes = geodesic_sizes(sides, edges, surface, closest, mode);
    inside = std::make_unique<GridComplex>(sides, edges, Side::inside);
    outside = std::make_unique<GridComplex>(sides, edges, Side::outside);
  }
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  const GridComplex& complex(Side side) const { return side == Side::inside ? *inside : *outside; }
  GridSizes sizes_on(Side side) const { return {complex(side), edges, sizes}; }
  DualPass pass_on(Side side) const { return dual_pass(complex(side), sizes_on(side)); }

  SmallVolume volume;
  VoxelSides sides;
  EdgeIndex edges;
  Surface surface;
  UnsetVector<std::uint32_t> closest;
  EdgeSizes sizes;
  std::unique_ptr<GridComplex> inside;
  std::unique_ptr<GridComplex> outside;
};

}  // namespace isoloop::testing
