// Values relative to the iso value, oriented so that the inside is never negative.
#pragma once

#include <algorithm>
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

}  // namespace isoloop
