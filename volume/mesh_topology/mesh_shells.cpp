#include "volume/mesh_topology/mesh_shells.h"

#include "core/base/disjoint_sets.h"

namespace isoloop {
namespace {

/// The corner of the side's triangle that is the point `low` of its edge; the other if not `low`.
std::uint32_t corner_at(const MeshEdge& side, bool low) {
  const bool begins = (side.way > 0) == low;
  const std::uint32_t corner = begins ? side.corner : (side.corner + 1U) % 3;
  return 3 * side.triangle + corner;
}

/// Corners that hang together across edges are one point of a surface.
DisjointSets corners_by_point(const Mesh& mesh, const std::vector<MeshEdge>& edges) {
  DisjointSets corners(static_cast<std::uint32_t>(3 * mesh.triangles.size()));
  for_each_edge(edges, [&](std::span<const MeshEdge> sides) {
    for (const bool low : {true, false}) {
      corners.unite(corner_at(sides[0], low), corner_at(sides[1], low));
    }
  });
  corners.flatten();
  return corners;
}

std::size_t points_in_triangles(const Mesh& mesh) {
  std::vector<bool> used(mesh.points.size());
  std::size_t count = 0;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      count += used[corner] ? 0 : 1;
      used[corner] = true;
    }
  }
  return count;
}

}  // namespace

Shells shells_of(const Mesh& mesh, const std::vector<MeshEdge>& edges) {
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  DisjointSets sets(count);
  for_each_edge(edges, [&](std::span<const MeshEdge> sides) {
    sets.unite(sides[0].triangle, sides[1].triangle);
  });
  sets.flatten();
  Shells shells;
  shells.of_triangle.resize(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    if (sets.root(t) == t) {
      shells.of_triangle[t] = static_cast<std::uint32_t>(shells.list.size());
      shells.list.push_back({.first = t, .euler = 0, .is_oriented = true});
    } else {
      shells.of_triangle[t] = shells.of_triangle[sets.root(t)];  // roots come first
    }
  }
  const auto shell_at = [&](std::uint32_t t) -> Shell& {
    return shells.list[shells.of_triangle[t]];
  };
  for_each_edge(edges, [&](std::span<const MeshEdge> sides) {
    Shell& shell = shell_at(sides[0].triangle);
    --shell.euler;
    if (sides[0].way == sides[1].way) shell.is_oriented = false;
  });
  const DisjointSets corners = corners_by_point(mesh, edges);
  std::size_t points = 0;
  for (std::uint32_t t = 0; t < count; ++t) {
    ++shell_at(t).euler;
    for (std::uint32_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
      if (corners.root(corner) != corner) continue;
      ++shell_at(t).euler;
      ++points;
    }
  }
  shells.pinches = points - points_in_triangles(mesh);
  return shells;
}

}  // namespace isoloop
