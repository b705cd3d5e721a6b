#include "volume/shapes/curve_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "volume/shapes/shape_field.h"

namespace isoloop {
namespace {

constexpr std::int64_t block_edge = 8;  // voxels

double squared_distance(const std::vector<Vec3>& points, std::size_t segment, const Vec3& p) {
  const std::size_t next = segment + 1 == points.size() ? 0 : segment + 1;
  return squared_segment_distance(p, points[segment], points[next]);
}

/// The segments that are nearest to some point within `reach` of `centre`, and a few more.
std::vector<std::uint32_t> nearest_segments(const std::vector<Vec3>& points, const Vec3& centre,
                                            double reach) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < points.size(); ++s) {
    least = std::min(least, squared_distance(points, s, centre));
  }
  // A point within reach of the centre is at most least + reach from the curve, so a segment
  // nearest to it is at most least + 2 reach from the centre.
  const double bound = std::sqrt(least) + 2.0 * reach + 1e-6;
  std::vector<std::uint32_t> found;
  for (std::size_t s = 0; s < points.size(); ++s) {
    if (squared_distance(points, s, centre) <= bound * bound) {
      found.push_back(static_cast<std::uint32_t>(s));
    }
  }
  return found;
}

}  // namespace

CurveDistance::CurveDistance(std::vector<Vec3> points, const Index3& dims)
    : points_(std::move(points)) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    blocks_[axis] = (dims[axis] + block_edge - 1) / block_edge;
  }
  const std::int64_t count = blocks_[0] * blocks_[1] * blocks_[2];
  candidates_.resize(static_cast<std::size_t>(count));
  const double half = 0.5 * static_cast<double>(block_edge);
  tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, count), [&](const auto& range) {
    for (std::int64_t b = range.begin(); b < range.end(); ++b) {
      const Index3 at{b % blocks_[0], b / blocks_[0] % blocks_[1], b / (blocks_[0] * blocks_[1])};
      Vec3 centre{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        centre[axis] = static_cast<double>(at[axis] * block_edge) + half;
      }
      candidates_[static_cast<std::size_t>(b)] =
          nearest_segments(points_, centre, std::sqrt(3.0) * half);
    }
  });
}

double CurveDistance::operator()(const Vec3& p) const {
  const auto block = [&](std::size_t axis) {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(p[axis]) / block_edge, 0,
                                    blocks_[axis] - 1);
  };
  const std::int64_t b = block(0) + blocks_[0] * (block(1) + blocks_[1] * block(2));
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t s : candidates_[static_cast<std::size_t>(b)]) {
    least = std::min(least, squared_distance(points_, s, p));
  }
  return std::sqrt(least);
}

}  // namespace isoloop
