// Signed distances of simple solids (negative inside), and volumes made by sampling them.
// All points and lengths are in voxels.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/grid/vec3.h"
#include "volume/base/memory_limit.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// Every shape keeps this far from the border, so voxels 0, 1 and 2 are outside. Not a round
/// number: no surface then runs through voxel centres by design.
inline constexpr double shape_margin = 2.6;

/// Largest extent of a solid in a volume of `size` voxels along its longest axis.
inline double shape_extent(std::int64_t size) {
  return static_cast<double>(size - 1) - 2.0 * shape_margin;
}

/// Dimensions that hold a solid of these extents; see shape_margin.
inline Index3 shape_dims(const Vec3& extents) {
  Index3 dims{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // The slack absorbs rounding, so that shape_extent(n) gives n again.
    dims[axis] =
        1 + static_cast<std::int64_t>(std::ceil(extents[axis] + 2.0 * shape_margin - 1e-9));
  }
  return dims;
}

/// The length of a vector of voxels: norm() allows for lengths that squares cannot hold, and takes
/// longer.
inline double root_of_squares(const Vec3& a) { return std::sqrt(dot(a, a)); }

inline double ball_distance(const Vec3& p, const Vec3& centre, double radius) {
  return root_of_squares(minus(p, centre)) - radius;
}

/// The ring's circle has its centre at `centre` and lies across coordinate axis `axis`.
inline double ring_distance(const Vec3& p, const Vec3& centre, std::size_t axis, double major,
                            double minor) {
  const Vec3 d = minus(p, centre);
  const double u = d[(axis + 1) % 3];
  const double v = d[(axis + 2) % 3];
  const double off = std::sqrt(u * u + v * v) - major;
  return std::sqrt(off * off + d[axis] * d[axis]) - minor;
}

/// A box from `low` to `high` whose edges are rounded off with `rounding`.
inline double box_distance(const Vec3& p, const Vec3& low, const Vec3& high, double rounding) {
  double outside = 0.0;
  double inside = -1e300;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double half = 0.5 * (high[axis] - low[axis]) - rounding;
    const double q = std::abs(p[axis] - 0.5 * (high[axis] + low[axis])) - half;
    inside = std::max(inside, q);
    if (q > 0.0) outside += q * q;
  }
  return std::sqrt(outside) + std::min(inside, 0.0) - rounding;
}

/// Squared distance to the segment from a to b; a = b is allowed.
inline double squared_segment_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = minus(b, a);
  const Vec3 d = minus(p, a);
  const double length = dot(along, along);
  const double t = length > 0.0 ? std::clamp(dot(d, along) / length, 0.0, 1.0) : 0.0;
  const Vec3 off{d[0] - t * along[0], d[1] - t * along[1], d[2] - t * along[2]};
  return dot(off, off);
}

/// A rod from a to b with round ends.
inline double rod_distance(const Vec3& p, const Vec3& a, const Vec3& b, double radius) {
  return std::sqrt(squared_segment_distance(p, a, b)) - radius;
}

/// A float32 signed-distance volume, spacing 1: values[i + dims[0] * (j + dims[1] * k)] =
/// distance({i, j, k}). Throws as check_voxel_memory does, with `max_bytes`. `distance` is called
/// from many threads.
template <class Distance>
Volume sample_distance(const Index3& dims, std::uint64_t max_bytes, const std::string& what,
                       const Distance& distance) {
  check_voxel_memory(dims, sizeof(float), max_bytes, what);
  std::vector<float> values(checked_voxel_count(dims, what));
  tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, dims[2]), [&](const auto& slabs) {
    for (std::int64_t k = slabs.begin(); k < slabs.end(); ++k) {
      for (std::int64_t j = 0; j < dims[1]; ++j) {
        float* row = values.data() + dims[0] * (j + dims[1] * k);
        for (std::int64_t i = 0; i < dims[0]; ++i) {
          row[i] = static_cast<float>(distance(
              Vec3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)}));
        }
      }
    }
  });
  Volume volume;
  volume.values = std::move(values);
  volume.dims = dims;
  volume.level_set = true;
  return volume;
}

}  // namespace isoloop
