#include "volume/mesh_closure.h"

#include <algorithm>
#include <utility>

namespace isoloop {

Closure closure_of(const Mesh& mesh) {
  struct Edge {
    std::uint32_t low, high;
    int way;  // 1 from low to high, else -1
  };
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t from = triangle[c];
      const std::uint32_t to = triangle[(c + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  });
  Closure closure;
  for (std::size_t i = 0; i < edges.size();) {
    std::int64_t sum = 0;
    const std::size_t first = i;
    for (;
         i < edges.size() && edges[i].low == edges[first].low && edges[i].high == edges[first].high;
         ++i) {
      sum += edges[i].way;
    }
    if ((i - first) % 2 != 0) ++closure.open_edges;
    if (sum != 0) ++closure.one_way_edges;
  }
  return closure;
}

}  // namespace isoloop
