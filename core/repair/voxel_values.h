// A grid whose values can be changed, in the type that they are stored in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "core/grid/grid.h"

namespace isoloop {

/// Bytes that a copy of the grid's values takes.
std::uint64_t value_bytes(const AnyGridView& grid);

/// A copy of a grid's values.
class VoxelValues {
 public:
  explicit VoxelValues(const AnyGridView& grid);

  /// Valid until this object ends.
  AnyGridView view() const;

  const Index3& dims() const { return dims_; }
  double at(std::size_t voxel) const;  // exact, but for integers above 2^53

  /// `value` must be one that nearest() gave, or at().
  void set(std::size_t voxel, double value);

  /// The value of the grid's type closest to the one that lies `magnitude` (unit of the values, not
  /// negative) away from iso inside or outside, and on that side. Nothing if the type has none.
  std::optional<double> nearest(double magnitude, bool inside, const IsoLevel& level) const;

 private:
  std::variant<std::vector<std::uint8_t>, std::vector<std::int8_t>, std::vector<std::uint16_t>,
               std::vector<std::int16_t>, std::vector<std::uint32_t>, std::vector<std::int32_t>,
               std::vector<float>, std::vector<double>>
      values_;
  Index3 dims_{};
  Vec3 spacing_{};
};

}  // namespace isoloop
