// A triangle mesh with fewer triangles and the same topology.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/grid/grid.h"

namespace isoloop {

struct TriangleMesh {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // corners in points
  std::vector<std::uint32_t> sources{};  // of each point of a simplified mesh: see simplified()
};

/// Collapses edges, the one that moves the surface least first (quadric error; Garland and
/// Heckbert, SIGGRAPH 1997), until no more than `most_triangles` are left or no edge may go. An
/// edge may go only if its two ends have no common neighbours but the two opposite it (the link
/// condition; Dey, Edelsbrunner, Guha, Nekhayev 1999): so the surface stays the same up to
/// homeomorphism, component by component, handle by handle. Nor may it turn a triangle over. Ends
/// on a border stay as they are. `mesh` must be a surface: each directed edge at most once, and
/// each vertex within one fan. The points that are left keep their order; `sources` says
/// which points of `mesh` they were. The result depends on `mesh` alone.
TriangleMesh simplified(TriangleMesh mesh, std::size_t most_triangles);

}  // namespace isoloop
