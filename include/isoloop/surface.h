// The iso-surface as a mesh, and what is counted of it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "isoloop/grid.h"

namespace isoloop {

/// Of I: its components, its independent tunnels (as many as the genus of M), and its cavities,
/// the components of O that do not reach the border. With an open boundary of M: its components,
/// its independent loops, and its components without a border.
struct Betti {
  std::int64_t b0 = 0;  // components
  std::int64_t b1 = 0;  // tunnels
  std::int64_t b2 = 0;  // cavities

  bool operator==(const Betti&) const = default;
};

/// One connected component of M: euler = 2 - 2 genus - borders.
struct SurfaceComponent {
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  std::int64_t euler = 0;
  std::int64_t genus = 0;
  std::int64_t borders = 0;    // closed curves along which it ends at the border of the grid
  bool bounds_cavity = false;  // I lies around it, not within it; false with an open boundary

  std::int64_t betti1() const { return 2 * genus + std::max<std::int64_t>(borders - 1, 0); }
};

/// M, oriented and triangulated; closed, or with an open boundary maybe ending at the grid's
/// border.
struct SurfaceMesh {
  /// In voxel indices of the grid.
  std::vector<std::array<float, 3>> points;
  /// Corners in points, counter-clockwise seen from O. Each directed edge occurs once.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> component_of_vertex;  // its place in components
  std::vector<SurfaceComponent> components;        // in the order of their first vertex
  Boundary boundary = Boundary::closed;
  Vec3 spacing{1.0, 1.0, 1.0};  // length per voxel: the unit of every length on M
};

}  // namespace isoloop
