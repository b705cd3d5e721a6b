// What the trilinear interpolant makes of a cube, counted by voxels: shares no table, no formula
// for saddles and no code with core/.
#pragma once

#include <array>
#include <optional>

namespace isoloop::oracle {

/// Of one side within a cube. chi = parts - b1: nothing within a cube encloses a cavity.
struct Parts {
  int parts = 0;
  int chi = 0;

  friend bool operator==(const Parts& a, const Parts& b) = default;
};

using CubeParts = std::array<Parts, 2>;  // outside (values < 0), inside

/// Samples the interpolant of the corner values (corner dx + 2 dy + 4 dz) at the (steps + 1)^3
/// vertices of a refined cube and counts, first with voxels joined by faces only, then by faces,
/// edges and corners. steps: at most 62.
std::array<CubeParts, 2> refined_parts(const std::array<double, 8>& values, int steps);

/// The counts on which both adjacencies agree at `steps` and at twice as many; empty if they do
/// not.
std::optional<CubeParts> converged_parts(const std::array<double, 8>& values, int steps);

/// Of the inside, the Euler characteristic alone, in the same way and in less time.
std::optional<int> converged_euler(const std::array<double, 8>& values, int steps);

}  // namespace isoloop::oracle
