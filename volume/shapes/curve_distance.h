// Distance to a closed curve, fast enough to be asked at every voxel.
#pragma once

#include <cstdint>
#include <vector>

#include "core/grid/grid.h"

namespace isoloop {

/// The distance to a closed polyline from points of the box [0, dims[0] - 1] x ... ; in voxels.
/// Invariant: a block's candidates hold the nearest segment of every point in the block.
class CurveDistance {
 public:
  /// `points` (voxels): at least one; the last is joined to the first.
  CurveDistance(std::vector<Vec3> points, const Index3& dims);

  /// `p` must lie in the box.
  double operator()(const Vec3& p) const;

 private:
  std::vector<Vec3> points_;
  Index3 blocks_{};
  std::vector<std::vector<std::uint32_t>> candidates_;  // segment s joins points s and s + 1
};

}  // namespace isoloop
