// Whose axes results speak of: a run counts along memory, a user along an array's own axes.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "tools/runs/run_result.h"

namespace isoloop::python {

/// For each axis of the grid, the fastest in memory first, the axis of the array that it is. A
/// permutation of 0, 1, 2.
using Axes = std::array<std::size_t, 3>;

/// Throws InvalidArgument where it is none.
void check_axes(const Axes& axes);

template <class T>
std::array<T, 3> in_array_axes(const Axes& axes, const std::array<T, 3>& along_grid) {
  std::array<T, 3> along_array{};
  for (std::size_t a = 0; a < 3; ++a) along_array[axes[a]] = along_grid[a];
  return along_array;
}

template <class T>
std::array<T, 3> in_grid_axes(const Axes& axes, const std::array<T, 3>& along_array) {
  std::array<T, 3> along_grid{};
  for (std::size_t a = 0; a < 3; ++a) along_grid[a] = along_array[axes[a]];
  return along_grid;
}

/// All that is along axes of the grid, turned to those of the array: points, centres, normals, the
/// spacing, and the side that triangles face.
void turn_to_array(const Axes& axes, CountRun& run);
void turn_to_array(const Axes& axes, LoopsRun& run);
void turn_to_array(const Axes& axes, RepairRun& run);

/// "voxel (2, 1, 0)" with its numbers in the order of the array's axes; other places as they are.
std::string place_in_array(const Axes& axes, const std::string& place);

}  // namespace isoloop::python
