#include "core/sizes/bounded_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoloop {
namespace {

constexpr std::size_t few = 8;     // goals whose distances are told apart
constexpr double rounding = 1e-5;  // of sums of single precision, relative
constexpr float unreached = std::numeric_limits<float>::infinity();

}  // namespace

BoundedSearch::BoundedSearch(const EdgeGraph& graph, const std::vector<Vec3>& points, double radius,
                             double bucket)
    : graph_(graph),
      points_(points),
      radius_(static_cast<float>(radius)),
      per_bucket_(1.0 / bucket),
      states_(graph.vertex_count()) {}

inline float BoundedSearch::length_to(std::uint32_t vertex) const {
  const State& state = states_[vertex];
  return state.round == round_ ? state.length : unreached;
}

void BoundedSearch::begin(std::span<Goal> goals) {
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
void BoundedSearch::aim() {
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
inline double BoundedSearch::least_through(std::uint32_t vertex, float length) const {
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

inline void BoundedSearch::reach(std::uint32_t vertex, float length) {
  states_[vertex] = {round_, length};
  const double least = least_through(vertex, length);
  if (least > radius_) return;
  // Numbers go round: what comes too early by that costs nothing but time.
  const auto number = std::max(static_cast<std::uint64_t>(least * per_bucket_), current_);
  last_ = std::max(last_, number);
  buckets_[number % bucket_count].push_back({vertex, length});
}

inline void BoundedSearch::follow(std::uint32_t vertex, float length) {
  graph_.for_each_out_edge(vertex, [&](std::uint32_t next, std::uint32_t edge) {
    const float through = length + graph_.lengths[edge];
    if (through <= radius_ && through < length_to(next)) reach(next, through);
  });
}

/// What waits in later buckets is too far off to make the path to a goal shorter.
inline void BoundedSearch::close_goals() {
  const auto is_final = [&](Goal* goal) {
    goal->length = length_to(goal->vertex);
    return goal->length * per_bucket_ < static_cast<double>(current_ + 1);
  };
  if (std::erase_if(open_, is_final) > 0) aim();
}

void BoundedSearch::run(std::uint32_t source, std::span<Goal> goals) {
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

}  // namespace isoloop
