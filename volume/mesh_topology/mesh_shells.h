// The closed surfaces that a mesh consists of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "volume/mesh/mesh.h"
#include "volume/mesh/mesh_edges.h"

namespace isoloop {

/// A closed surface: triangles that hang together across edges.
struct Shell {
  std::uint32_t first = 0;   // the triangle of least number
  std::int64_t euler = 0;    // points - edges + triangles; a point where it touches itself is two
  bool is_oriented = false;  // its triangles agree on which side is outside
};

struct Shells {
  std::vector<std::uint32_t> of_triangle{};  // the place in `list` of each triangle's shell
  std::vector<Shell> list{};                 // by their first triangles
  std::size_t pinches = 0;  // points where shells touch, or where one touches itself
};

/// What shells_of() takes for each triangle.
inline constexpr std::uint64_t shell_bytes_per_triangle = 24;

/// Of a mesh whose edges all have two triangles; `edges`: those of the mesh.
Shells shells_of(const Mesh& mesh, const std::vector<MeshEdge>& edges);

}  // namespace isoloop
