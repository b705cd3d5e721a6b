// The rule for ties (docs/topology.md) by itself, and the places of vertices and triangles, on
// cubes of few levels.
#pragma once

#include <array>

#include "core/grid/level.h"
#include "tests/oracles/cube_geometry.h"

namespace isoloop::testing {

/// What was found wrong in some cubes, over all topologies.
struct TiedCubes {
  int cubes = 0;
  int tunnels = 0;
  int against_the_rule = 0;   // another cut than with all levels but the zeros lowered
  int against_the_sweep = 0;  // other parts or cycles than the interpolant's, followed in slices
  int off_the_cube = 0;       // a vertex that is not finite or not strictly within its edge or cube
  int crossings = 0;          // pairs of triangles that cross
  int without_area = 0;       // triangles
};

inline constexpr double least_share_of_surface = 1e-3;

/// Vertices and triangles, for every topology and both parities.
inline void check_geometry(const CornerLevels& levels, TiedCubes& found) {
  ++found.cubes;
  for (const Topology topology : {Topology::trilinear, Topology::simple, Topology::connected_6,
                                  Topology::connected_18, Topology::connected_26}) {
    CornerLevels deciding = levels;
    for (double& level : deciding) level = deciding_level(level, topology);
    LevelCut cut = cut_of(deciding);
    if (topology == Topology::simple) {
      cut.hub.reset();
      cut.cut = cut.plain;
    }
    if (topology == Topology::trilinear && cut.hub) ++found.tunnels;
    const CubeVertices vertices = vertices_of(levels, deciding, cut, least_share_of_surface);
    if (!lie_within(vertices, cut, least_share_of_surface)) ++found.off_the_cube;
    for (const bool odd : {false, true}) {
      const TriangleFaults faults = triangle_faults(vertices, cut, odd);
      found.crossings += faults.crossings;
      found.without_area += faults.without_area;
    }
  }
}

/// The same, and the rule. `levels`: whole numbers of magnitude 2 or less.
inline void check_cube(const CornerLevels& levels, TiedCubes& found) {
  check_geometry(levels, found);
  const LevelCut cut = cut_of(levels);
  for (const double by : {0x1p-10, 0x1p-16}) {
    CornerLevels lowered = levels;
    for (double& level : lowered)
      if (level != 0) level -= by;
    const LevelCut expected = cut_of(lowered);
    if (cut.joined != expected.joined || cut.hub != expected.hub) ++found.against_the_rule;
  }
  const oracle::SweptCube swept = oracle::sweep(levels, 0x1p-16);
  oracle::CubeParts parts{};
  for (std::size_t side = 0; side < 2; ++side)
    parts[side] = {swept.parts[side], swept.parts[side] - swept.cycles[side]};
  if (parts_of(cut) != parts) ++found.against_the_sweep;
}

/// All cubes of that many levels, an odd number: whole numbers about 0.
inline TiedCubes check_all_cubes(int level_count) {
  TiedCubes found;
  const int highest = level_count / 2;
  std::array<int, 8> digits{};
  while (true) {
    CornerLevels levels{};
    for (std::size_t c = 0; c < 8; ++c) levels[c] = digits[c] - highest;
    check_cube(levels, found);
    std::size_t c = 0;
    while (c < 8 && ++digits[c] == level_count) digits[c++] = 0;
    if (c == 8) return found;
  }
}

}  // namespace isoloop::testing
