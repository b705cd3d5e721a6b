#include "core/repair/voxel_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/grid/level.h"

namespace isoloop {
namespace {

/// The next value of the type towards the inside or away from it.
template <class T>
std::optional<T> next_value(T value, bool upwards) {
  if constexpr (std::is_floating_point_v<T>) {
    const T next = std::nextafter(
        value, upwards ? std::numeric_limits<T>::infinity() : -std::numeric_limits<T>::infinity());
    if (!std::isfinite(next)) return std::nullopt;
    return next;
  } else {
    if (value == (upwards ? std::numeric_limits<T>::max() : std::numeric_limits<T>::min()))
      return std::nullopt;
    return static_cast<T>(upwards ? value + 1 : value - 1);
  }
}

template <class T>
std::optional<double> nearest_value(double wanted, bool upwards, bool inside,
                                    const IsoLevel& level) {
  const auto least = static_cast<double>(std::numeric_limits<T>::lowest());
  const auto most = static_cast<double>(std::numeric_limits<T>::max());
  const double clamped = std::clamp(wanted, least, most);
  T value = static_cast<T>(std::is_floating_point_v<T> ? clamped : std::nearbyint(clamped));
  // Rounding, to the type or of iso + magnitude, is off by a step or two at most.
  for (int step = 0; step < 4; ++step) {
    if ((level_of(value, level) >= 0.0) == inside) return static_cast<double>(value);
    const std::optional<T> next = next_value(value, upwards);
    if (!next) return std::nullopt;
    value = *next;
  }
  return std::nullopt;
}

}  // namespace

std::uint64_t value_bytes(const AnyGridView& grid) {
  return std::visit([](const auto& view) { return std::uint64_t{view.values.size_bytes()}; }, grid);
}

VoxelValues::VoxelValues(const AnyGridView& grid) {
  std::visit(
      [&]<class T>(const GridView<T>& view) {
        values_ = std::vector<T>(view.values.begin(), view.values.end());
        dims_ = view.dims;
        spacing_ = view.spacing;
      },
      grid);
}

AnyGridView VoxelValues::view() const {
  return std::visit(
      [&]<class T>(const std::vector<T>& values) {
        return AnyGridView(GridView<T>{values, dims_, spacing_});
      },
      values_);
}

double VoxelValues::at(std::size_t voxel) const {
  return std::visit([&](const auto& values) { return static_cast<double>(values[voxel]); },
                    values_);
}

void VoxelValues::set(std::size_t voxel, double value) {
  std::visit([&]<class T>(std::vector<T>& values) { values[voxel] = static_cast<T>(value); },
             values_);
}

std::optional<double> VoxelValues::nearest(double magnitude, bool inside,
                                           const IsoLevel& level) const {
  const bool upwards = inside == (level.inside == InsideRule::above);
  // No value lies farther within a band than its middle.
  if (inside && level.upper) magnitude = std::min(magnitude, (*level.upper - level.iso) / 2);
  const double offset = upwards ? magnitude : -magnitude;
  return std::visit(
      [&]<class T>(const std::vector<T>&) {
        const auto found = nearest_value<T>(level.iso + offset, upwards, inside, level);
        if (found || !level.upper) return found;
        return nearest_value<T>(*level.upper - offset, !upwards, inside, level);
      },
      values_);
}

}  // namespace isoloop
