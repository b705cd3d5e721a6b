#include "tests/oracles/literal_pair.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "core/surface/surface_order.h"
#include "tests/oracles/slow_reduction.h"

namespace isoloop::testing {
namespace {

using oracle::Chain;
using Node = std::pair<bool, std::uint32_t>;  // on M?, vertex of M or of the lattice

/// An edge of a piece's border: where it runs, and its place in the filtration.
using Key = std::tuple<bool, float, bool, std::uint32_t, std::uint32_t>;  // off M, size, diagonal

struct BorderEdge {
  Key key;
  std::array<Node, 2> ends;
};

class Literal {
 public:
  Literal(const Prepared& prepared, Side side, Refinement refinement)
      : prepared_(prepared),
        complex_(prepared.complex(side)),
        sizes_(prepared.sizes_on(side)),
        side_(side),
        by_size_(refinement == Refinement::second || refinement == Refinement::both),
        shortest_cycle_(refinement == Refinement::first || refinement == Refinement::both),
        order_(order_surface(prepared.surface)) {}

  std::vector<LiteralPair> run() {
    std::vector<std::uint32_t> pieces = all_pieces(complex_);
    std::sort(pieces.begin(), pieces.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(size(a), a) < std::pair(size(b), b);
    });
    std::vector<std::pair<std::uint32_t, std::vector<std::array<Key, 3>>>> fans;
    for (std::uint32_t row = 0; row < order_.row_count(); ++row) keys_.insert(key_on_surface(row));
    for (const std::uint32_t piece : pieces) {
      fans.emplace_back(piece, fan_of(piece));
      for (const auto& triangle : fans.back().second)
        keys_.insert(triangle.begin(), triangle.end());
    }
    int next = 0;
    for (const Key& key : keys_) row_of_key_[key] = next++;
    for (const auto& [a, b, c] : order_.killed_cycles)
      pair_triangle({key_on_surface(a), key_on_surface(b), key_on_surface(c)}, 0);
    for (const auto& [a, b, c] : prepared_.surface.triangles)  // those left, one a component
      pair_triangle({key_between(a, b), key_between(b, c), key_between(c, a)}, 0);
    for (const auto& [piece, fan] : fans)
      for (const auto& triangle : fan) pair_triangle(triangle, piece);
    return pairs_;
  }

 private:
  float size(std::uint32_t piece) const { return by_size_ ? sizes_.of_piece(piece) : 0.0F; }

  static Key key_on_surface(std::uint32_t row) { return {false, 0.0F, false, row, 0}; }

  Key key_between(std::uint32_t a, std::uint32_t b) const {
    return key_on_surface(row_between(prepared_.surface, order_, a, b));
  }

  std::vector<BorderEdge> border(std::uint32_t piece) const {
    std::vector<BorderEdge> edges;
    for (const std::uint32_t edge : complex_.edges_of(piece)) {
      const float length = by_size_ ? sizes_.of_edge(edge) : 0.0F;
      std::array<Node, 2> ends{};
      for (std::uint32_t i = 0; i < 2; ++i) {
        const std::uint32_t vertex = edge / 3 + i * prepared_.sides.lattice.stride[edge % 3];
        ends[i] = prepared_.sides.is_on(side_, vertex)
                      ? Node{false, vertex}
                      : Node{true, prepared_.edges.vertex_on(edge)};
      }
      edges.push_back({{true, length, false, edge, 0}, ends});
    }
    for (const auto& [a, b] : complex_.segments(piece))
      edges.push_back({key_between(a, b), {Node{true, a}, Node{true, b}}});
    return edges;
  }

  /// The border in cyclic order, cut into triangles from its first vertex.
  std::vector<std::array<Key, 3>> fan_of(std::uint32_t piece) const {
    std::vector<BorderEdge> ring = border(piece);
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
      const auto next =
          std::find_if(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, ring.end(),
                       [&](const BorderEdge& edge) {
                         return edge.ends[0] == ring[i].ends[1] || edge.ends[1] == ring[i].ends[1];
                       });
      if (next->ends[0] != ring[i].ends[1]) std::swap(next->ends[0], next->ends[1]);
      std::swap(ring[i + 1], *next);
    }
    std::vector<std::array<Key, 3>> fan;
    Key side_before = ring[0].key;
    for (std::uint32_t i = 1; i + 1 < ring.size(); ++i) {
      const Key side_after =
          i + 2 == ring.size() ? ring[i + 1].key : Key{true, size(piece), true, piece, i};
      fan.push_back({side_before, ring[i].key, side_after});
      side_before = side_after;
    }
    return fan;
  }

  bool is_on_surface(const Chain& cycle) const {
    return cycle.back() < static_cast<int>(order_.row_count());
  }

  double length(const Chain& cycle) const {
    double sum = 0.0;
    for (const int row : cycle) {
      const auto& [a, b] = order_.edges[static_cast<std::size_t>(row)];
      sum += distance(scaled_point(prepared_.surface, a), scaled_point(prepared_.surface, b));
    }
    return sum;
  }

  void pair_triangle(const std::array<Key, 3>& border, std::uint32_t piece) {
    Chain cycle;
    for (const Key& key : border) cycle = oracle::sum(cycle, {row_of_key_.at(key)});
    const bool on_surface = is_on_surface(cycle);
    Chain shortest;
    while (!cycle.empty()) {
      if (is_on_surface(cycle) && (shortest.empty() || is_shorter(length(cycle), length(shortest))))
        shortest = cycle;
      const auto killed = killed_by_row_.find(cycle.back());
      if (killed == killed_by_row_.end()) break;
      cycle = oracle::sum(cycle, killed->second);
    }
    if (cycle.empty()) return;
    killed_by_row_[cycle.back()] = cycle;
    if (on_surface || !is_on_surface(cycle)) return;
    LiteralPair& pair = pairs_.emplace_back();
    pair.piece = piece;
    for (const int row : shortest_cycle_ ? shortest : cycle)
      pair.cycle.insert(order_.edges[static_cast<std::size_t>(row)]);
  }

  const Prepared& prepared_;
  const GridComplex& complex_;
  GridSizes sizes_;
  Side side_;
  bool by_size_;
  bool shortest_cycle_;
  SurfaceOrder order_;
  std::set<Key> keys_;
  std::map<Key, int> row_of_key_;
  std::map<int, Chain> killed_by_row_;  // by youngest row
  std::vector<LiteralPair> pairs_;
};

}  // namespace

std::vector<LiteralPair> literal_pairs(const Prepared& prepared, Side side, Refinement refinement) {
  return Literal(prepared, side, refinement).run();
}

}  // namespace isoloop::testing
