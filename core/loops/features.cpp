#include "core/loops/features.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/base/errors.h"
#include "core/base/per_thread.h"
#include "core/base/threads.h"
#include "core/curves/triangle_fans.h"
#include "core/grid/vec3.h"

namespace isoloop {
namespace {

constexpr float far = std::numeric_limits<float>::infinity();
constexpr double most_fronts_to_a_length = 4096.0;  // of the loop: voxels may be very flat

/// One front: the places at one distance from the loop, on one side of it.
struct Front {
  double length = 0.0;
  Vec3 centroid{};  // units of length
};

/// One side of a loop as far as it is swept.
struct SweptSide {
  bool open = true;
  double way = 0.0;   // distance of the last front
  double step = 0.0;  // between the centroids of the last front and the one before
  Front last;
};

void add_segment(Front& front, const Vec3& p, const Vec3& q) {
  const double length = distance(p, q);
  front.length += length;
  for (std::size_t x = 0; x < 3; ++x) front.centroid[x] += length * (p[x] + q[x]) / 2;
}

void finish(Front& front) {
  if (!(front.length > 0.0)) return;
  for (double& x : front.centroid) x /= front.length;
}

double triangle_area(const Surface& surface, const std::array<std::uint32_t, 3>& corners) {
  const Vec3 p = scaled_point(surface, corners[0]);
  return norm(cross(minus(scaled_point(surface, corners[1]), p),
                    minus(scaled_point(surface, corners[2]), p))) /
         2;
}

Front front_along(const Surface& surface, const Loop& loop) {
  Front front;
  for (const Curve& curve : loop.curves)
    for_each_edge(curve, [&](std::uint32_t u, std::uint32_t v) {
      add_segment(front, scaled_point(surface, u), scaled_point(surface, v));
    });
  finish(front);
  return front;
}

/// Its length is twice the area that the loop spans.
Vec3 normal_of(const Surface& surface, const Loop& loop) {
  Vec3 normal{};
  for (const Curve& curve : loop.curves)
    for_each_edge(curve, [&](std::uint32_t u, std::uint32_t v) {
      const Vec3 turn = cross(scaled_point(surface, u), scaled_point(surface, v));
      for (std::size_t x = 0; x < 3; ++x) normal[x] += turn[x];
    });
  return normal;
}

/// Of length 1, its largest component positive.
Vec3 without_direction(Vec3 axis) {
  const double length = norm(axis);
  if (!(length > 0.0)) return {};
  const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double largest = *std::max_element(axis.begin(), axis.end(), less);
  for (double& x : axis) x /= std::copysign(length, largest);
  return axis;
}

/// Keeps its arrays between loops: one object a thread.
class Sweep {
 public:
  Sweep(const Surface& surface, const TriangleFans& fans, double ratio)
      : surface_(surface),
        fans_(fans),
        ratio_(ratio),
        least_step_(std::min({surface.spacing[0], surface.spacing[1], surface.spacing[2]})),
        longest_edge_(
            *std::max_element(surface.graph.lengths.begin(), surface.graph.lengths.end())),
        distance_(surface.points.size(), far),
        side_(surface.points.size()) {}

  Feature run(const Loop& loop) {
    start(loop);
    const Front first = front_along(surface_, loop);
    const double step = std::max(least_step_, loop.length / most_fronts_to_a_length);
    std::array<SweptSide, 3> sides{};  // 0: the loop itself
    sides[0].open = false;
    for (SweptSide& side : sides) side.last = first;
    Feature feature{.least_girth = loop.length, .mean_girth = loop.length};
    std::size_t fronts = 1;
    double level = step;
    while (sides[1].open || sides[2].open) {
      // Beyond the level, so that the corners of the triangles that it crosses are settled.
      settle_up_to(level + longest_edge_, sides);
      const std::array<Front, 3> met = fronts_at(level);
      for (std::size_t s = 1; s < 3; ++s) {
        if (!sides[s].open) continue;
        advance(sides[s], met[s], level, ratio_ * loop.length);
        feature.depth += sides[s].step;
        if (!sides[s].open || level >= meeting_) continue;
        feature.least_girth = std::min(feature.least_girth, met[s].length);
        feature.mean_girth += met[s].length;
        ++fronts;
      }
      level = next_level(level, step);
    }
    feature.mean_girth /= static_cast<double>(fronts);
    const Vec3 chord = minus(sides[2].last.centroid, sides[1].last.centroid);
    feature.axis = without_direction(norm(chord) >= feature.depth / 2 && feature.depth >= step
                                         ? chord
                                         : normal_of(surface_, loop));
    for (const std::uint32_t vertex : reached_)
      if (distance_[vertex] <= sides[side_[vertex]].way) feature.vertices.push_back(vertex);
    std::sort(feature.vertices.begin(), feature.vertices.end());
    feature.area = area_of(feature.vertices);
    clear();
    return feature;
  }

 private:
  using Entry = std::pair<float, std::uint32_t>;

  /// Moves the side on to the front at `level`, or ends it there.
  static void advance(SweptSide& side, const Front& front, double level, double longest) {
    const bool gone = !(front.length > 0.0);
    side.open = !gone && front.length <= longest;
    side.step = side.open ? distance(side.last.centroid, front.centroid) : 0.0;
    if (side.open || gone) side.way = level;  // gone: all is swept
    if (side.open) side.last = front;
  }

  void reach(std::uint32_t vertex, float distance, std::uint8_t side) {
    if (distance_[vertex] == far) reached_.push_back(vertex);
    distance_[vertex] = distance;
    side_[vertex] = side;
    queue_.emplace(distance, vertex);
  }

  /// Puts the loop's vertices in the queue, and tells the sides of the vertices next to them.
  void start(const Loop& loop) {
    for (const Curve& curve : loop.curves)
      for (const std::uint32_t vertex : curve) reach(vertex, 0.0F, 0);
    for (const Curve& curve : loop.curves)
      for (std::size_t i = 0; i < curve.size(); ++i) {
        const std::uint32_t before = curve[(i + curve.size() - 1) % curve.size()];
        const std::uint32_t here = curve[i];
        const std::uint32_t after = curve[(i + 1) % curve.size()];
        for (std::uint32_t v = fans_.apex(here, after); v != before; v = fans_.apex(here, v))
          mark(v, 1);
        for (std::uint32_t v = fans_.apex(after, here); v != before; v = fans_.apex(v, here))
          mark(v, 2);
      }
  }

  /// Vertices beside the loop only, which the search reaches first.
  void mark(std::uint32_t vertex, std::uint8_t side) {
    if (distance_[vertex] != 0.0F && side_[vertex] == 0) side_[vertex] = side;
  }

  void settle_up_to(double level, const std::array<SweptSide, 3>& sides) {
    while (!queue_.empty() && queue_.top().first <= level) {
      const float distance = queue_.top().first;
      const std::uint32_t vertex = queue_.top().second;
      queue_.pop();
      if (distance > distance_[vertex]) continue;
      const std::uint8_t side = side_[vertex];
      if (side != 0 && !sides[side].open) continue;
      rim_.push_back(vertex);
      surface_.graph.for_each_out_edge(vertex, [&](std::uint32_t to, std::uint32_t edge) {
        if (side != 0 && side_[to] == 3 - side && distance_[to] <= distance)
          meeting_ = std::min(meeting_, static_cast<double>(distance));
        const float way = distance + surface_.graph.lengths[edge];
        if (way < distance_[to]) reach(to, way, side != 0 ? side : side_[to]);
      });
    }
  }

  /// A step on, or more where no vertex lies there: along voxels far longer than wide fronts stay
  /// within the same triangles for thousands of steps.
  double next_level(double level, double step) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t vertex : rim_)
      if (distance_[vertex] > level) nearest = std::min<double>(nearest, distance_[vertex]);
    return std::isfinite(nearest) ? std::max(level + step, nearest) : level + step;
  }

  /// The fronts of both sides, from the triangles that the level crosses.
  std::array<Front, 3> fronts_at(double level) {
    std::array<Front, 3> fronts{};
    std::size_t kept = 0;
    for (const std::uint32_t vertex : rim_) {
      bool is_rim = distance_[vertex] > level;
      if (!is_rim)
        for (const std::uint32_t t : fans_.triangles(vertex))
          is_rim = add_crossing(surface_.triangles[t], vertex, level, fronts) || is_rim;
      if (is_rim) rim_[kept++] = vertex;
    }
    rim_.resize(kept);
    for (Front& front : fronts) finish(front);
    return fronts;
  }

  /// Whether the level crosses the triangle; its segment counts at its least corner within.
  bool add_crossing(const std::array<std::uint32_t, 3>& corners, std::uint32_t vertex, double level,
                    std::array<Front, 3>& fronts) const {
    std::uint32_t least = vertex;
    std::uint8_t side = 0;
    bool crosses = false;
    for (const std::uint32_t corner : corners) {
      if (distance_[corner] <= level) {
        least = std::min(least, corner);
      } else {
        if (distance_[corner] == far) return false;
        crosses = true;
        side = std::max(side, side_[corner]);
      }
    }
    if (!crosses || least != vertex) return crosses;
    std::array<Vec3, 2> ends{};
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = corners[i];
      const std::uint32_t b = corners[(i + 1) % 3];
      if ((distance_[a] > level) == (distance_[b] > level)) continue;
      const double share = (level - distance_[a]) / (distance_[b] - distance_[a]);
      const Vec3 p = scaled_point(surface_, a);
      const Vec3 q = scaled_point(surface_, b);
      for (std::size_t x = 0; x < 3; ++x) ends[found][x] = p[x] + share * (q[x] - p[x]);
      ++found;
    }
    add_segment(fronts[side], ends[0], ends[1]);
    return true;
  }

  /// Of the triangles with all corners among `vertices`, ascending.
  double area_of(const std::vector<std::uint32_t>& vertices) const {
    double area = 0.0;
    const auto within = [&](std::uint32_t vertex) {
      return std::binary_search(vertices.begin(), vertices.end(), vertex);
    };
    for (const std::uint32_t vertex : vertices)
      for (const std::uint32_t t : fans_.triangles(vertex)) {
        const auto& corners = surface_.triangles[t];
        if (*std::min_element(corners.begin(), corners.end()) == vertex &&
            std::all_of(corners.begin(), corners.end(), within))
          area += triangle_area(surface_, corners);
      }
    return area;
  }

  void clear() {
    for (const std::uint32_t vertex : reached_) {
      distance_[vertex] = far;
      side_[vertex] = 0;
    }
    reached_.clear();
    rim_.clear();
    queue_ = {};
    meeting_ = far;
  }

  const Surface& surface_;
  const TriangleFans& fans_;
  double ratio_;
  double least_step_;  // from front to front: a voxel
  double longest_edge_;
  double meeting_ = far;  // the least distance at which the sides meet away from the loop
  std::vector<float> distance_;
  std::vector<std::uint8_t> side_;  // 0 on the loop, 1 or 2
  std::vector<std::uint32_t> reached_;
  std::vector<std::uint32_t> rim_;  // settled, and at or beyond the last level
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

// Bytes a vertex of M: of M with its graph; of the fans and of a search, both at most.
constexpr std::uint64_t surface_share = 110;
constexpr std::uint64_t fans_share = 28;
constexpr std::uint64_t search_share = 32;

}  // namespace

std::vector<Feature> features_of(const Surface& surface, const std::vector<Loop>& loops,
                                 const FeatureOptions& options) {
  std::vector<Feature> features(loops.size());
  if (loops.empty()) return features;
  const std::uint64_t vertices = surface.points.size();
  const int searches = threads_within("features", (surface_share + fans_share) * vertices,
                                      search_share * vertices, options.max_bytes, thread_count());
  const std::uint64_t room =
      options.max_bytes - (surface_share + fans_share + search_share) * vertices;
  const TriangleFans fans(surface);
  std::atomic<std::uint64_t> kept = 0;
  const auto run = [&](Sweep& sweep, std::size_t i) {
    features[i] = sweep.run(loops[i]);
    features[i].vertices.shrink_to_fit();
    kept += sizeof(std::uint32_t) * features[i].vertices.size();
    if (kept <= room) return;
    throw LimitExceeded({.text = "the vertices of the features outgrow " + bytes_text(room) +
                                 ", which is what the limit leaves",
                         .advice = {Advice::raise_memory_limit, Advice::take_part}},
                        {.unit = Excess::Unit::bytes, .limit = room, .stage = "features"});
  };
  with_threads(searches, [&] {
    PerThread<Sweep> sweeps;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, loops.size(), 1), [&](const auto& range) {
      Sweep& sweep = sweeps.local([&] { return Sweep(surface, fans, options.ratio); });
      for (std::size_t i = range.begin(); i < range.end(); ++i) run(sweep, i);
    });
  });
  return features;
}

std::uint64_t held_bytes(const Surface& surface, const std::vector<Feature>& features) {
  std::uint64_t bytes = surface_share * surface.points.size();
  for (const Feature& feature : features) bytes += sizeof(std::uint32_t) * feature.vertices.size();
  return bytes;
}

}  // namespace isoloop
