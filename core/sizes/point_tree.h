// Finds the nearest of many points, which lie in an order that keeps near ones together.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/grid/grid.h"

namespace isoloop {

using Point = std::array<float, 3>;

/// Boxes round runs of points, round runs of these boxes, and so on. Exact for any order of the
/// points; fast where neighbours in number are neighbours in space, as M's vertices are. Keeps a
/// reference to the points, which must outlive it.
class PointTree {
 public:
  /// `points`: not empty; a distance along axis a counts as so many times `scale`[a].
  PointTree(std::span<const Point> points, const Vec3& scale);

  /// The point nearest to `place`; of several, the first. `guess`: some point, the nearer the
  /// better.
  std::uint32_t nearest(const Vec3& place, std::uint32_t guess) const;

  /// The points, ascending, that may be nearest to some place no farther than `half`[a] along each
  /// axis a from `center`; `nearest`: to the center. Replaces `rivals`.
  void find_rivals(const Vec3& center, const Vec3& half, std::uint32_t nearest,
                   std::vector<std::uint32_t>& rivals) const;

 private:
  static constexpr std::uint32_t fan = 8;  // boxes, or points, in a box

  static constexpr float infinite = std::numeric_limits<float>::infinity();

  struct Box {
    Point low{infinite, infinite, infinite};
    Point high{-infinite, -infinite, -infinite};
  };

  double squared_distance(const Vec3& place, const Point& point) const;
  double squared_distance(const Vec3& place, const Box& box) const;

  std::span<const Point> points_;
  Vec3 scale_;
  std::vector<std::vector<Box>> tiers_;  // the first round points, the last one of one box
};

}  // namespace isoloop
