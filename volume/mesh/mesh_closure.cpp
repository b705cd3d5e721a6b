#include "volume/mesh/mesh_closure.h"

#include <cstdint>

#include "volume/mesh/mesh_edges.h"

namespace isoloop {

Closure closure_of(const Mesh& mesh) {
  Closure closure;
  for_each_edge(edges_of(mesh), [&](std::span<const MeshEdge> sides) {
    std::int64_t sum = 0;
    for (const MeshEdge& side : sides) sum += side.way;
    if (sides.size() % 2 != 0) ++closure.open_edges;
    if (sum != 0) ++closure.one_way_edges;
  });
  return closure;
}

}  // namespace isoloop
