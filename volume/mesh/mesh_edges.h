// The edges of a mesh, each with the triangles at it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "volume/mesh/mesh.h"

namespace isoloop {

/// One triangle's side.
struct MeshEdge {
  std::uint32_t low = 0;   // the lesser of its two points
  std::uint32_t high = 0;  // the greater
  std::uint32_t triangle = 0;
  std::uint8_t corner = 0;  // of the triangle, where the side begins; it ends at the next
  std::int8_t way = 0;      // 1: it runs from low to high, else -1
};

/// What edges_of() holds for each triangle.
inline constexpr std::uint64_t edge_bytes_per_triangle = 3 * sizeof(MeshEdge);

/// All sides of all triangles, by their points, then by triangle: those of one edge come together.
std::vector<MeshEdge> edges_of(const Mesh& mesh);

/// Calls visit(std::span<const MeshEdge>) for each edge, with the sides that lie at it.
template <class Visit>
void for_each_edge(const std::vector<MeshEdge>& edges, const Visit& visit) {
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t last = first + 1;
    while (last < edges.size() && edges[last].low == edges[first].low &&
           edges[last].high == edges[first].high) {
      ++last;
    }
    visit(std::span(edges).subspan(first, last - first));
    first = last;
  }
}

}  // namespace isoloop
