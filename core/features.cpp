#include "core/features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "core/triangle_fans.h"

namespace isoloop {
namespace {

constexpr float far = std::numeric_limits<float>::infinity();

/// One front at one distance: where distance to the loop has that value, on one side of it.
struct Front {
  double length = 0.0;
  Vec3 centroid{};  // units of length
};

double norm(const Vec3& v) { return std::hypot(v[0], v[1], v[2]); }

Vec3 difference(const Vec3& p, const Vec3& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

Vec3 cross(const Vec3& u, const Vec3& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// Keeps its arrays between loops: one object a thread.
class Sweep {
 public:
  Sweep(const Surface& surface, const TriangleFans& fans, double ratio)
      : surface_(surface),
        fans_(fans),
        ratio_(ratio),
        step_(std::min({surface.spacing[0], surface.spacing[1], surface.spacing[2]})),
        distance_(surface.points.size(), far),
        side_(surface.points.size()),
        is_settled_(surface.points.size()) {}

  Feature run(const Loop& loop) {
    start(loop);
    const double longest = ratio_ * loop.length;
    std::array<bool, 3> open{false, true, true};
    std::array<double, 3> way{};
    std::array<Front, 3> last{};
    double least = loop.length;
    double sum = loop.length;
    std::size_t count = 1;
    for (std::size_t k = 1; open[1] || open[2]; ++k) {
      const double level = static_cast<double>(k) * step_;
      settle_up_to(level, open);
      const std::array<Front, 3> fronts = fronts_at(level);
      for (std::size_t side = 1; side < 3; ++side) {
        if (!open[side]) continue;
        const Front& front = fronts[side];
        open[side] = front.length > 0.0 && front.length <= longest;
        if (!open[side]) continue;
        way[side] = level;
        last[side] = front;
        least = std::min(least, front.length);
        sum += front.length;
        ++count;
      }
    }
    Feature feature;
    feature.depth = way[1] + way[2];
    feature.least_girth = least;
    feature.mean_girth = sum / static_cast<double>(count);
    feature.axis = axis_of(loop, last);
    for (const std::uint32_t vertex : reached_)
      if (is_settled_[vertex] && distance_[vertex] <= way[side_[vertex]])
        feature.vertices.push_back(vertex);
    std::sort(feature.vertices.begin(), feature.vertices.end());
    feature.area = area_of(feature.vertices);
    clear();
    return feature;
  }

 private:
  using Entry = std::pair<float, std::uint32_t>;

  void reach(std::uint32_t vertex, float distance, std::uint8_t side) {
    if (distance_[vertex] == far) reached_.push_back(vertex);
    distance_[vertex] = distance;
    side_[vertex] = side;
    queue_.emplace(distance, vertex);
  }

  /// Puts the loop's vertices in the queue and tells the sides of the vertices next to them: the
  /// apices of the triangles on the loop's edges are on known sides, and neighbours agree.
  void start(const Loop& loop) {
    for (const Curve& curve : loop.curves)
      for (const std::uint32_t vertex : curve) reach(vertex, 0.0F, 0);
    std::vector<std::uint32_t> todo;
    const auto mark = [&](std::uint32_t vertex, std::uint8_t side) {
      if (distance_[vertex] == 0.0F || side_[vertex] != 0) return;
      side_[vertex] = side;
      todo.push_back(vertex);
    };
    for (const Curve& curve : loop.curves)
      for (std::size_t i = 0; i < curve.size(); ++i) {
        const std::uint32_t a = curve[i];
        const std::uint32_t b = curve[(i + 1) % curve.size()];
        mark(fans_.apex(a, b), 1);
        mark(fans_.apex(b, a), 2);
      }
    std::vector<std::uint32_t> beside;
    for (const Curve& curve : loop.curves)
      for (const std::uint32_t vertex : curve)
        surface_.graph.for_each_out_edge(
            vertex, [&](std::uint32_t to, std::uint32_t) { beside.push_back(to); });
    std::sort(beside.begin(), beside.end());
    marked_ = todo;
    for (std::size_t i = 0; i < todo.size(); ++i)
      surface_.graph.for_each_out_edge(todo[i], [&](std::uint32_t to, std::uint32_t) {
        if (!std::binary_search(beside.begin(), beside.end(), to)) return;
        mark(to, side_[todo[i]]);
      });
    marked_ = todo;
  }

  void settle_up_to(double level, const std::array<bool, 3>& open) {
    while (!queue_.empty() && queue_.top().first <= level) {
      const auto [distance, vertex] = queue_.top();
      queue_.pop();
      if (is_settled_[vertex] || distance > distance_[vertex]) continue;
      is_settled_[vertex] = true;
      const std::uint8_t side = side_[vertex];
      if (side != 0 && !open[side]) continue;
      rim_.push_back(vertex);
      surface_.graph.for_each_out_edge(vertex, [&](std::uint32_t to, std::uint32_t edge) {
        const float way = distance + surface_.graph.lengths[edge];
        if (is_settled_[to] || way >= distance_[to]) return;
        reach(to, way, side != 0 ? side : side_[to]);
      });
    }
  }

  /// The fronts of both sides, from the triangles that the level crosses.
  std::array<Front, 3> fronts_at(double level) {
    std::array<Front, 3> fronts{};
    std::vector<std::uint32_t> rim;
    for (const std::uint32_t vertex : rim_) {
      bool is_rim = false;
      for (const std::uint32_t t : fans_.triangles(vertex)) {
        const auto& corners = surface_.triangles[t];
        std::uint32_t first = vertex;  // the triangle counts at its least corner within the level
        bool crosses = false;
        std::uint8_t side = 0;
        for (const std::uint32_t corner : corners) {
          if (distance_[corner] > level) {
            crosses = true;
            side = std::max(side, side_[corner]);
          } else {
            first = std::min(first, corner);
          }
        }
        is_rim = is_rim || crosses;
        if (crosses && first == vertex) add_segment(corners, level, fronts[side]);
      }
      if (is_rim) rim.push_back(vertex);
    }
    rim_ = std::move(rim);
    for (Front& front : fronts)
      if (front.length > 0.0)
        for (double& x : front.centroid) x /= front.length;
    return fronts;
  }

  void add_segment(const std::array<std::uint32_t, 3>& corners, double level, Front& front) const {
    std::array<Vec3, 2> ends{};
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3 && found < 2; ++i) {
      const std::uint32_t a = corners[i];
      const std::uint32_t b = corners[(i + 1) % 3];
      if ((distance_[a] > level) == (distance_[b] > level)) continue;
      if (distance_[a] == far || distance_[b] == far) return;
      const double share = (level - distance_[a]) / (distance_[b] - distance_[a]);
      const Vec3 p = scaled_point(surface_, a);
      const Vec3 q = scaled_point(surface_, b);
      for (std::size_t x = 0; x < 3; ++x) ends[found][x] = p[x] + share * (q[x] - p[x]);
      ++found;
    }
    const double length = distance(ends[0], ends[1]);
    front.length += length;
    for (std::size_t x = 0; x < 3; ++x) front.centroid[x] += length * (ends[0][x] + ends[1][x]) / 2;
  }

  Vec3 axis_of(const Loop& loop, const std::array<Front, 3>& last) const {
    Vec3 axis{};
    if (last[1].length > 0.0 && last[2].length > 0.0)
      axis = difference(last[2].centroid, last[1].centroid);
    if (norm(axis) < step_) {
      axis = {};
      for (const Curve& curve : loop.curves)
        for (std::size_t i = 0; i < curve.size(); ++i) {
          const Vec3 turn = cross(scaled_point(surface_, curve[i]),
                                  scaled_point(surface_, curve[(i + 1) % curve.size()]));
          for (std::size_t x = 0; x < 3; ++x) axis[x] += turn[x];
        }
    }
    const double length = norm(axis);
    if (length > 0.0)
      for (double& x : axis) x /= length;
    return axis;
  }

  /// Of the triangles with all corners among `vertices`, ascending.
  double area_of(const std::vector<std::uint32_t>& vertices) const {
    double area = 0.0;
    const auto within = [&](std::uint32_t vertex) {
      return std::binary_search(vertices.begin(), vertices.end(), vertex);
    };
    for (const std::uint32_t vertex : vertices)
      for (const std::uint32_t t : fans_.triangles(vertex)) {
        const auto& [a, b, c] = surface_.triangles[t];
        if (std::min({a, b, c}) != vertex || !within(a) || !within(b) || !within(c)) continue;
        const Vec3 p = scaled_point(surface_, a);
        area += norm(cross(difference(scaled_point(surface_, b), p),
                           difference(scaled_point(surface_, c), p))) /
                2;
      }
    return area;
  }

  void clear() {
    for (const std::uint32_t vertex : reached_) {
      distance_[vertex] = far;
      side_[vertex] = 0;
      is_settled_[vertex] = false;
    }
    for (const std::uint32_t vertex : marked_) side_[vertex] = 0;
    reached_.clear();
    rim_.clear();
    queue_ = {};
  }

  const Surface& surface_;
  const TriangleFans& fans_;
  double ratio_;
  double step_;  // of the levels: a voxel
  std::vector<float> distance_;
  std::vector<std::uint8_t> side_;  // 0 on the loop, 1 or 2
  std::vector<bool> is_settled_;
  std::vector<std::uint32_t> reached_;
  std::vector<std::uint32_t> marked_;  // beside the loop
  std::vector<std::uint32_t> rim_;     // settled; beside vertices that are not
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

std::vector<Feature> features_of(const Surface& surface, const std::vector<Loop>& loops,
                                 const FeatureOptions& options) {
  std::vector<Feature> features(loops.size());
  if (loops.empty()) return features;
  const TriangleFans fans(surface);
  tbb::enumerable_thread_specific<Sweep> sweeps(
      [&] { return Sweep(surface, fans, options.ratio); });
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, loops.size(), 1), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      features[i] = sweeps.local().run(loops[i]);
  });
  return features;
}

}  // namespace isoloop
