// The strip of triangles that a closed path on M runs through, and the shortest path within it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/grid/grid.h"
#include "core/surface/surface.h"

namespace isoloop {

/// An edge of M that a path crosses, and where: at (1 - at) * right + at * left.
struct Portal {
  std::uint32_t left = 0;  // vertices of M, as seen along the path
  std::uint32_t right = 0;
  double at = 0.0;  // 0 to 1
};

/// In units of length.
Vec3 point_on(const Surface& surface, const Portal& portal);

/// Of the closed path that joins the points of the portals, in units of length.
double length_of_path(const Surface& surface, std::span<const Portal> portals);

/// Moves the points, all but the first, to where the path is shortest. Of portals that follow one
/// another, the last and the first included, one end is the same, and the two other ends and it are
/// a triangle of M. Lays the triangles out in the plane and pulls a string through them (the funnel
/// of Lee and Preparata, Networks 14, 1984). A path that turns at a vertex goes through it exactly:
/// `at` is 0 or 1. Linear in the portals but for each turn.
void pull_taut(const Surface& surface, std::span<Portal> portals);

}  // namespace isoloop
