// Values relative to the iso value, oriented so that the inside is never negative.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/grid.h"

namespace isoloop {

/// Non-negative exactly where `value` is inside. Finite: products of two levels stay finite.
template <class T>
double level_of(T value, const IsoLevel& level) {
  constexpr double largest = 1e150;
  const double difference = static_cast<double>(value) - level.iso;
  const double oriented = level.inside == InsideRule::above ? difference : -difference;
  return std::clamp(oriented, -largest, largest);
}

/// Levels at the corners of a cube that lies within the grid; `lowest`: its lowest corner's voxel.
template <class T>
std::array<double, 8> corner_levels(const GridView<T>& grid, const IsoLevel& level,
                                    const Index3& lowest) {
  std::array<double, 8> levels{};
  for (int c = 0; c < 8; ++c) {
    const std::int64_t x = lowest[0] + (c & 1);
    const std::int64_t y = lowest[1] + (c >> 1 & 1);
    const std::int64_t z = lowest[2] + (c >> 2 & 1);
    levels[c] = level_of(grid.values[x + grid.dims[0] * (y + grid.dims[1] * z)], level);
  }
  return levels;
}

}  // namespace isoloop
