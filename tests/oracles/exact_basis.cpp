#include "tests/oracles/exact_basis.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <map>
#include <queue>
#include <unordered_map>
#include <vector>

namespace isoloop::testing {
namespace {

/// A class of H1(M): bit k is generator k of SurfaceClasses.
using Bits = std::uint64_t;
using Lengths = std::unordered_map<Bits, double>;  // by class

constexpr double slack = 1e-9;  // so that rounding cannot drop a loop as long as the bound

void lower(Lengths& lengths, Bits bits, double length) {
  const auto [at, is_new] = lengths.try_emplace(bits, length);
  if (!is_new) at->second = std::min(at->second, length);
}

struct Neighbor {
  std::uint32_t vertex;
  double length;
  Bits bits;
};

std::vector<std::vector<Neighbor>> neighbors_of(const Surface& surface,
                                                const SurfaceClasses& classes) {
  std::vector<std::vector<Neighbor>> neighbors(surface.points.size());
  for (std::uint32_t u = 0; u < neighbors.size(); ++u)
    surface.graph.for_each_out_edge(u, [&](std::uint32_t v, std::uint32_t edge) {
      Bits bits = 0;
      for (const std::uint32_t generator : classes.pool.generators(classes.of_edge[edge]))
        bits |= Bits{1} << generator;
      neighbors[u].push_back(
          {v, distance(scaled_point(surface, u), scaled_point(surface, v)), bits});
    });
  return neighbors;
}

/// The shortest closed walk of each class up to `longest`.
class ClosedWalks {
 public:
  ClosedWalks(const Surface& surface, const SurfaceClasses& classes, double longest)
      : neighbors_(neighbors_of(surface, classes)), longest_(longest) {}

  /// Every closed walk counts at its lowest vertex, so that the search from a vertex need not go to
  /// any lower one.
  void search_all() {
    for (std::uint32_t base = 0; base < neighbors_.size(); ++base) search(base, base);
  }

  /// A shortest walk is two halves, each the shortest of its class, and the edge that its middle is
  /// on; both halves are at most half as long.
  void search(std::uint32_t base, std::uint32_t lowest) {
    using Entry = std::pair<double, std::pair<std::uint32_t, Bits>>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::unordered_map<std::uint32_t, Lengths> reached;
    std::unordered_map<std::uint32_t, Lengths> settled;
    queue.push({0.0, {base, 0}});
    reached[base][0] = 0.0;
    while (!queue.empty() && 2.0 * queue.top().first <= longest_) {
      const double there = queue.top().first;
      const auto [vertex, bits] = queue.top().second;
      queue.pop();
      if (!settled[vertex].try_emplace(bits, there).second) continue;
      for (const Neighbor& next : neighbors_[vertex]) {
        if (next.vertex < lowest) continue;
        const double through = there + next.length;
        for (const auto& [back_bits, back] : settled[next.vertex])
          if (through + back <= longest_)
            lower(lengths_, bits ^ next.bits ^ back_bits, through + back);
        if (2.0 * through > longest_) continue;
        const auto [at, is_new] = reached[next.vertex].try_emplace(bits ^ next.bits, through);
        if (!is_new && at->second <= through) continue;
        at->second = through;
        queue.push({through, {next.vertex, bits ^ next.bits}});
      }
    }
  }

  const Lengths& lengths() const { return lengths_; }

 private:
  std::vector<std::vector<Neighbor>> neighbors_;
  double longest_;
  Lengths lengths_;
};

/// The shortest cycle of each class that bounds, of one closed walk or of several of which no part
/// bounds: Dijkstra's search on the classes, where a step adds a walk.
Lengths cycles_that_bound(const Lengths& walks, Bits own, double longest) {
  std::vector<std::pair<double, Bits>> steps;
  for (const auto& [bits, length] : walks)
    if (bits != 0) steps.emplace_back(length, bits);
  std::sort(steps.begin(), steps.end());
  Lengths least;
  Lengths bounding;
  std::priority_queue<std::pair<double, Bits>, std::vector<std::pair<double, Bits>>, std::greater<>>
      queue;
  queue.push({0.0, 0});
  while (!queue.empty()) {
    const auto [so_far, bits] = queue.top();
    queue.pop();
    if (!least.try_emplace(bits, so_far).second) continue;
    if (bits != 0 && (bits & own) == 0) {
      bounding.emplace(bits, so_far);
      continue;
    }
    for (const auto& [length, step] : steps) {
      if (so_far + length > longest) break;
      queue.push({so_far + length, bits ^ step});
    }
  }
  return bounding;
}

}  // namespace

double least_basis_length(const Surface& surface, const SurfaceClasses& classes, Side side,
                          double longest) {
  longest *= 1.0 + slack;
  ClosedWalks walks(surface, classes, longest);
  walks.search_all();
  const Bits inside = (Bits{1} << classes.inside_rank) - 1;
  const Lengths bounding =
      cycles_that_bound(walks.lengths(), side == Side::inside ? inside : ~inside, longest);
  std::vector<std::pair<double, Bits>> sorted;
  for (const auto& [bits, length] : bounding) sorted.emplace_back(length, bits);
  std::sort(sorted.begin(), sorted.end());
  std::map<Bits, Bits> row_of_top;  // by highest bit
  double total = 0.0;
  for (const auto& [length, bits] : sorted) {
    Bits rest = bits;
    for (auto row = row_of_top.rbegin(); row != row_of_top.rend(); ++row)
      if ((rest & row->first) != 0) rest ^= row->second;
    if (rest == 0) continue;
    row_of_top.emplace(Bits{1} << (63 - std::countl_zero(rest)), rest);
    total += length;
  }
  const auto genus = static_cast<std::size_t>(surface.genus());
  return row_of_top.size() == genus ? total : std::numeric_limits<double>::infinity();
}

std::map<GeneratorSet, double> closed_walks(const Surface& surface, const SurfaceClasses& classes,
                                            std::uint32_t base, double longest) {
  ClosedWalks walks(surface, classes, longest);
  walks.search(base, 0);
  std::map<GeneratorSet, double> lengths;
  for (const auto& [bits, length] : walks.lengths()) {
    GeneratorSet set;
    for (Bits rest = bits; rest != 0; rest &= rest - 1)
      set.push_back(static_cast<std::uint32_t>(std::countr_zero(rest)));
    lengths[set] = length;
  }
  return lengths;
}

}  // namespace isoloop::testing
