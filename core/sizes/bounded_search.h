// Shortest paths from one vertex to a few others, made for hundreds of thousands of small searches
// in a row.
#pragma once

#include <array>
#include <cstdint>
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
                double bucket);

  /// Sets the lengths of the goals: infinity where there is no path up to the radius. `goals` are
  /// distinct and `source` is not among them.
  void run(std::uint32_t source, std::span<Goal> goals);

 private:
  static constexpr std::uint64_t bucket_count = 64;

  struct State {
    std::uint32_t round = 0;  // the search that last reached the vertex
    float length = 0.0F;      // of the path, in that search
  };
  struct Waiting {
    std::uint32_t vertex;
    float length;
  };

  float length_to(std::uint32_t vertex) const;
  double least_through(std::uint32_t vertex, float length) const;
  void begin(std::span<Goal> goals);
  void aim();
  void reach(std::uint32_t vertex, float length);
  void follow(std::uint32_t vertex, float length);
  void close_goals();

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
  std::vector<Vec3> centers_;  // of balls that hold the open goals
  double ball_ = 0.0;          // radius of these
};

}  // namespace isoloop
