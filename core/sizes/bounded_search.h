// Shortest paths from one vertex to a few others, made for hundreds of thousands of small searches
// in a row.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/grid/grid.h"
#include "core/surface/edge_graph.h"

namespace isoloop {

/// What a search looks for.
struct Goal {
  std::uint32_t vertex = 0;
  float length = 0.0F;  // of the shortest path, once found: unit of the graph's lengths
};

/// The A* search (Hart, Nilsson, Raphael, IEEE Transactions on Systems Science and Cybernetics 4,
/// 1968): no edge is shorter than the straight line, so a path is followed only while what is left
/// of the radius may lead to a goal. Vertices wait in buckets and are corrected rather than sorted
/// (Dial, Communications of the ACM 12, 1969; Meyer, Sanders, Journal of Algorithms 49, 2003): the
/// shortest of all sums along paths, each rounded from the source on, is the same in any order.
/// Keeps its arrays between searches; a search costs time in proportion to what it reaches.
class BoundedSearch {
 public:
  /// Keeps references: graph and points, by vertex, must outlive it. Unit of `radius` and
  /// `bucket`: that of the lengths. `bucket`: about half of a usual edge; it decides the speed
  /// alone.
  BoundedSearch(const EdgeGraph& graph, const std::vector<Vec3>& points, double radius,
                double bucket)
      : graph_(graph),
        points_(points),
        radius_(static_cast<float>(radius)),
        per_bucket_(1.0 / bucket),
        states_(graph.vertex_count()) {}

  /// Sets the lengths of the goals: infinity where there is no path up to the radius. `goals` are
  /// distinct and `source` is not among them.
  void run(std::uint32_t source, std::span<Goal> goals) {
    begin(goals);
    reach(source, 0.0F);
    for (current_ = last_; !open_.empty() && current_ <= last_; ++current_) {
      auto& bucket = buckets_[current_ % bucket_count];
      for (std::size_t i = 0; i < bucket.size(); ++i) {  // which may grow
        const auto [vertex, length] = bucket[i];
        if (length == states_[vertex].length) follow(vertex, length);
      }
      bucket.clear();
      close_goals();
    }
    for (; current_ <= last_; ++current_) buckets_[current_ % bucket_count].clear();
    for (Goal* const goal : open_) goal->length = length_to(goal->vertex);
  }

 private:
  static constexpr std::uint64_t bucket_count = 64;
  static constexpr std::size_t few = 8;     // goals whose distances are told apart
  static constexpr double rounding = 1e-5;  // of sums of single precision, relative
  static constexpr float unreached = std::numeric_limits<float>::infinity();

  struct State {
    std::uint32_t round = 0;  // the search that last reached the vertex
    float length = 0.0F;      // of the path, in that search
  };
  struct Waiting {
    std::uint32_t vertex;
    float length;
  };

  float length_to(std::uint32_t vertex) const {
    const State& state = states_[vertex];
    return state.round == round_ ? state.length : unreached;
  }

  void begin(std::span<Goal> goals) {
    if (++round_ == 0) {  // after 2^32 searches: no stale entry may look current
      std::fill(states_.begin(), states_.end(), State{});
      round_ = 1;
    }
    open_.clear();
    for (Goal& goal : goals) open_.push_back(&goal);
    last_ = 0;
    current_ = 0;
    aim();
  }

  /// Balls of one radius round the open goals: around each if they are few, else around all.
  void aim() {
    centers_.clear();
    ball_ = 0.0;
    for (const Goal* goal : open_) centers_.push_back(points_[goal->vertex]);
    if (centers_.size() <= few) return;
    Vec3 mean{};
    for (const Vec3& center : centers_)
      for (int a = 0; a < 3; ++a) mean[a] += center[a] / static_cast<double>(centers_.size());
    for (const Vec3& center : centers_) ball_ = std::max(ball_, distance(center, mean));
    centers_.assign(1, mean);
  }

  /// No path through `vertex` to an open goal is shorter, if it takes `length` to get there.
  double least_through(std::uint32_t vertex, float length) const {
    double least = std::numeric_limits<double>::infinity();
    const Vec3& p = points_[vertex];
    for (const Vec3& q : centers_) {
      const double dx = p[0] - q[0];
      const double dy = p[1] - q[1];
      const double dz = p[2] - q[2];
      least = std::min(least, dx * dx + dy * dy + dz * dz);
    }
    return (length + std::max(std::sqrt(least) - ball_, 0.0)) * (1.0 - rounding);
  }

  void reach(std::uint32_t vertex, float length) {
    states_[vertex] = {round_, length};
    const double least = least_through(vertex, length);
    if (least > radius_) return;
    // Numbers go round: what comes too early by that costs nothing but time.
    const auto number = std::max(static_cast<std::uint64_t>(least * per_bucket_), current_);
    last_ = std::max(last_, number);
    buckets_[number % bucket_count].push_back({vertex, length});
  }

  void follow(std::uint32_t vertex, float length) {
    graph_.for_each_out_edge(vertex, [&](std::uint32_t next, std::uint32_t edge) {
      const float through = length + graph_.lengths[edge];
      if (through <= radius_ && through < length_to(next)) reach(next, through);
    });
  }

  /// What waits in later buckets is too far off to make the path to a goal shorter.
  void close_goals() {
    const auto is_final = [&](Goal* goal) {
      goal->length = length_to(goal->vertex);
      return goal->length * per_bucket_ < static_cast<double>(current_ + 1);
    };
    if (std::erase_if(open_, is_final) > 0) aim();
  }

  const EdgeGraph& graph_;
  const std::vector<Vec3>& points_;
  float radius_;
  double per_bucket_;
  std::vector<State> states_;
  std::array<std::vector<Waiting>, bucket_count> buckets_;  // by the least length through each
  std::uint64_t current_ = 0;                               // number of the bucket at hand
  std::uint64_t last_ = 0;                                  // none that waits is in a later one
  std::uint32_t round_ = 0;
  std::vector<Goal*> open_;
  std::vector<Vec3> centers_;
  double ball_ = 0.0;
};

}  // namespace isoloop
