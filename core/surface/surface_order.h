// PAIR on M alone: which edges of M stay unpaired, and the cycles that its triangles kill.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/surface/surface.h"

namespace isoloop {

/// M's edges in an order in which PAIR (Dey, Li, Sun, Cohen-Steiner, SIGGRAPH 2008, algorithm 1)
/// pairs all that M can pair without adding one cycle to another. The paper leaves the order
/// within M open. Rows, from the oldest:
///   [0, tree)        a spanning forest: paired with vertices
///   [tree, killed)   rank H1(M) edges: the positive edges that stay unpaired
///   [killed, end)    edges across which a spanning forest of M's triangles runs, leaves first:
///                    row r is paired with one triangle, whose border is killed_cycles[r - killed]
struct SurfaceOrder {
  std::uint32_t tree = 0;
  std::uint32_t killed = 0;
  std::vector<std::array<std::uint32_t, 2>> edges;          // by row: vertices of M, ascending
  std::vector<std::array<std::uint32_t, 3>> killed_cycles;  // rows; the youngest is the pair's own
  std::vector<std::uint32_t> row_of_edge;                   // by edge number of the graph

  std::uint32_t row_count() const { return static_cast<std::uint32_t>(edges.size()); }
};

/// Linear in M. Throws SelfCheckFailed unless surface.betti1() edges stay unpaired.
SurfaceOrder order_surface(const Surface& surface);

/// Row of the edge between two vertices of M; they must be joined by one.
std::uint32_t row_between(const Surface& surface, const SurfaceOrder& order, std::uint32_t a,
                          std::uint32_t b);

}  // namespace isoloop
