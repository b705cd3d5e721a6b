// Where the triangles of one cube lie, and whether they keep out of each other's way.
#pragma once

#include <array>
#include <cstdint>

#include "core/cube/cube_interior.h"
#include "tests/oracles/cut_of_levels.h"

namespace isoloop::testing {

/// In shares of the cube's edges: first the vertices on its edges, then the ring round its tunnel;
/// 0 where the cut has no such vertex.
using CubeVertices = std::array<Vec3, first_ring_vertex + ring_size>;

/// As extract_surface() places them. The tunnel's levels may be others than those along the edges,
/// as they are for masks.
CubeVertices vertices_of(const CornerLevels& levels, const CornerLevels& tunnel_levels,
                         const LevelCut& cut, double least_share);

/// Whether each vertex that the cut has is finite and at least `least_share` away from the cube's
/// corners along its edge, or from its faces if it lies within.
bool lie_within(const CubeVertices& vertices, const LevelCut& cut, double least_share);

/// How often triangles of the cut, with its diagonals for cubes of that parity, have more in common
/// than the vertices that they share, and how many have no area. Exact for vertices rounded to
/// 2^-30.
struct TriangleFaults {
  int crossings = 0;
  int without_area = 0;
};
TriangleFaults triangle_faults(const CubeVertices& vertices, const LevelCut& cut, bool odd);

}  // namespace isoloop::testing
