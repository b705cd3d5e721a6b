#include "volume/mesh/mesh_edges.h"

#include <algorithm>
#include <tuple>

#include <tbb/parallel_sort.h>

namespace isoloop {

std::vector<MeshEdge> edges_of(const Mesh& mesh) {
  std::vector<MeshEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint8_t c = 0; c < 3; ++c) {
      const std::uint32_t from = mesh.triangles[t][c];
      const std::uint32_t to = mesh.triangles[t][(c + 1U) % 3];
      edges.push_back({.low = std::min(from, to),
                       .high = std::max(from, to),
                       .triangle = static_cast<std::uint32_t>(t),
                       .corner = c,
                       .way = static_cast<std::int8_t>(from < to ? 1 : -1)});
    }
  }
  tbb::parallel_sort(edges.begin(), edges.end(), [](const MeshEdge& a, const MeshEdge& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) <
           std::tie(b.low, b.high, b.triangle, b.corner);
  });
  return edges;
}

}  // namespace isoloop
