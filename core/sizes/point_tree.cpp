#include "core/sizes/point_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/inplace_vector.h"

namespace isoloop {
namespace {

constexpr std::size_t most_tiers = 11;  // 8^11 > 2^32

}  // namespace

PointTree::PointTree(std::span<const Point> points, const Vec3& scale)
    : points_(points), scale_(scale) {
  std::vector<Box>& first = tiers_.emplace_back((points.size() + fan - 1) / fan);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Box& box = first[i / fan];
    for (std::size_t a = 0; a < 3; ++a) {
      box.low[a] = std::min(box.low[a], points[i][a]);
      box.high[a] = std::max(box.high[a], points[i][a]);
    }
  }
  while (tiers_.back().size() > 1) {
    const std::vector<Box>& below = tiers_.back();
    std::vector<Box> tier((below.size() + fan - 1) / fan);
    for (std::size_t i = 0; i < below.size(); ++i) {
      Box& box = tier[i / fan];
      for (std::size_t a = 0; a < 3; ++a) {
        box.low[a] = std::min(box.low[a], below[i].low[a]);
        box.high[a] = std::max(box.high[a], below[i].high[a]);
      }
    }
    tiers_.push_back(std::move(tier));
  }
}

double PointTree::squared_distance(const Vec3& place, const Point& point) const {
  double sum = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const double d = scale_[a] * (place[a] - point[a]);
    sum += d * d;
  }
  return sum;
}

/// No more than to any point within: each step rounds as it does there.
double PointTree::squared_distance(const Vec3& place, const Box& box) const {
  double sum = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const double d = scale_[a] * (place[a] - std::clamp<double>(place[a], box.low[a], box.high[a]));
    sum += d * d;
  }
  return sum;
}

std::uint32_t PointTree::nearest(const Vec3& place, std::uint32_t guess) const {
  struct Node {
    std::size_t tier;
    std::uint32_t box;
    double squared;
  };
  InplaceVector<Node, most_tiers * fan> todo;
  std::uint32_t best = guess;
  double least = squared_distance(place, points_[guess]);
  todo.push_back({tiers_.size() - 1, 0, 0.0});
  while (todo.count > 0) {
    const Node node = todo[--todo.count];
    if (node.squared > least) continue;
    const std::uint32_t begin = node.box * fan;
    if (node.tier == 0) {
      const auto end = std::min<std::size_t>(begin + fan, points_.size());
      for (std::uint32_t i = begin; i < end; ++i) {
        const double squared = squared_distance(place, points_[i]);
        if (squared < least || (squared == least && i < best)) {
          least = squared;
          best = i;
        }
      }
      continue;
    }
    const std::vector<Box>& below = tiers_[node.tier - 1];
    const auto end = std::min<std::size_t>(begin + fan, below.size());
    const std::uint32_t first = todo.count;
    for (std::uint32_t i = begin; i < end; ++i) {
      const double squared = squared_distance(place, below[i]);
      if (squared > least) continue;
      // The nearest box last, which is the first to be looked into.
      std::uint32_t at = todo.count++;
      for (; at > first && todo.items[at - 1].squared < squared; --at)
        todo.items[at] = todo.items[at - 1];
      todo.items[at] = {node.tier - 1, i, squared};
    }
  }
  return best;
}

// With places p, points q and the nearest point c as seen from the center, and of p what is within
// the halves h: |p - q|^2 - |p - c|^2 = |q|^2 - |c|^2 - 2 p (q - c), and that is nowhere less than
// |q|^2 - |c|^2 - 2 sum h |q - c|. Where it is above 0, c is nearer.
void PointTree::find_rivals(const Vec3& center, const Vec3& half, std::uint32_t nearest,
                            std::vector<std::uint32_t>& rivals) const {
  const Point& c = points_[nearest];
  const double least = squared_distance(center, c);
  const double allowance = 1e-9 * (1.0 + least);  // far more than rounding makes of it
  const auto is_behind = [&](const Point& low, const Point& high, double squared) {
    double gain = 0.0;
    for (std::size_t a = 0; a < 3; ++a)
      gain += half[a] * scale_[a] * scale_[a] *
              std::max(std::abs(double{low[a]} - c[a]), std::abs(double{high[a]} - c[a]));
    return squared - least - 2.0 * gain > allowance;
  };
  struct Node {
    std::size_t tier;
    std::uint32_t box;
  };
  InplaceVector<Node, most_tiers * fan> todo;
  rivals.clear();
  todo.push_back({tiers_.size() - 1, 0});
  while (todo.count > 0) {
    const auto [tier, box] = todo[--todo.count];
    const std::uint32_t begin = box * fan;
    if (tier == 0) {
      const auto end = std::min<std::size_t>(begin + fan, points_.size());
      for (std::uint32_t i = begin; i < end; ++i)
        if (!is_behind(points_[i], points_[i], squared_distance(center, points_[i])))
          rivals.push_back(i);
      continue;
    }
    const std::vector<Box>& below = tiers_[tier - 1];
    for (auto i = static_cast<std::uint32_t>(std::min<std::size_t>(begin + fan, below.size()));
         i-- > begin;)
      if (!is_behind(below[i].low, below[i].high, squared_distance(center, below[i])))
        todo.push_back({tier - 1, i});
  }
}

}  // namespace isoloop
