// Closed tubes of triangles round closed polylines.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/grid/grid.h"

namespace isoloop {

/// Corners of a tube round each vertex of its polyline.
inline constexpr std::uint32_t tube_sides = 6;

struct Tube {
  std::vector<Vec3> points;                             // tube_sides for each vertex, in order
  std::vector<std::array<std::uint32_t, 3>> triangles;  // corners in points, normals leading out
};

/// A torus of triangles round `polyline`, whose last point joins its first; `radius` is in the
/// unit of the points. The rings turn as little as they can from one to the next. Points that
/// coincide or turn back on themselves give a thin tube, never NaN. Fewer than two points: empty.
Tube closed_tube(std::span<const Vec3> polyline, double radius);

}  // namespace isoloop
