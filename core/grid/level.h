// Values relative to the iso value, oriented so that the inside is never negative.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/grid/grid.h"

namespace isoloop {

/// The values that are inside: from `least` to `most`, themselves included.
struct InsideValues {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();

  template <class T>
  bool hold(T value) const {
    return static_cast<double>(value) >= least && static_cast<double>(value) <= most;
  }
};

inline InsideValues inside_values(const IsoLevel& level) {
  InsideValues values;
  if (level.inside == InsideRule::above) {
    values.least = level.iso;
    if (level.upper) values.most = *level.upper;
  } else {
    values.most = level.iso;
  }
  return values;
}

/// Non-negative exactly where `value` is inside. Finite.
template <class T>
double level_of(T value, const IsoLevel& level) {
  constexpr double largest = std::numeric_limits<double>::max();
  const double difference = static_cast<double>(value) - level.iso;
  double oriented = level.inside == InsideRule::above ? difference : -difference;
  if (level.upper) oriented = std::min(oriented, *level.upper - static_cast<double>(value));
  return std::clamp(oriented, -largest, largest);
}

/// The level that decides what is joined within cubes and faces, of the same sign as `oriented`:
/// itself unless the topology goes by signs alone. Then it is one of two numbers whose interpolant
/// has that topology. On an ambiguous face the side of the larger one is joined. Two opposite
/// corners of a cube are joined if it is more than three times the other: the interpolant of
/// corners a, a and six of -b is (a - 3 b) / 4 at the centre.
inline double deciding_level(double oriented, Topology topology) {
  const bool inside = oriented >= 0.0;
  switch (topology) {
    case Topology::trilinear:
    case Topology::simple:
      return oriented;
    case Topology::connected_6:
      return inside ? 0.125 : -1.0;
    case Topology::connected_18:
      return inside ? 1.0 : -0.5;
    case Topology::connected_26:
      return inside ? 1.0 : -0.125;
  }
  return oriented;
}

/// Deciding levels at the corners of a cube that lies within the grid; `lowest`: its lowest
/// corner's voxel.
template <class T>
std::array<double, 8> corner_levels(const GridView<T>& grid, const IsoLevel& level,
                                    const Index3& lowest) {
  std::array<double, 8> levels{};
  for (int c = 0; c < 8; ++c) {
    const std::int64_t x = lowest[0] + (c & 1);
    const std::int64_t y = lowest[1] + (c >> 1 & 1);
    const std::int64_t z = lowest[2] + (c >> 2 & 1);
    const T value = grid.values[x + grid.dims[0] * (y + grid.dims[1] * z)];
    levels[c] = deciding_level(level_of(value, level), level.topology);
  }
  return levels;
}

}  // namespace isoloop
