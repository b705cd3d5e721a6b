// A triangle mesh with fewer triangles.
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

/// `keep`: the mesh keeps its topology. `drop_small`: what is narrower than the triangles may close
/// up, and sheets may come to touch.
enum class HandleRule { keep, drop_small };

/// Collapses edges, the one that moves the surface least first (quadric error; Garland and
/// Heckbert, SIGGRAPH 1997), until no more than `most_triangles` are left or no edge may go. To
/// keep handles, an edge may go only if its two ends have no common neighbours but the two opposite
/// it (the link condition; Dey, Edelsbrunner, Guha, Nekhayev 1999): so the surface stays the same
/// up to homeomorphism, component by component, handle by handle. No edge that goes may turn a
/// triangle over. Ends on a border stay as they are. `mesh` must be a surface: each directed edge
/// at most once, and each vertex within one fan. The points that are left keep their order;
/// `sources` says which points of `mesh` they were. The result depends on `mesh` alone.
TriangleMesh simplified(TriangleMesh mesh, std::size_t most_triangles,
                        HandleRule handles = HandleRule::keep);

}  // namespace isoloop
