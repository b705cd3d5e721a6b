#include "volume/mesh_topology/mesh_counts.h"

#include <limits>
#include <vector>

#include "volume/mesh/mesh.h"
#include "volume/mesh/mesh_edges.h"
#include "volume/mesh_topology/mesh_crossing.h"
#include "volume/mesh_topology/mesh_gap.h"
#include "volume/mesh_topology/mesh_nesting.h"
#include "volume/mesh_topology/mesh_shells.h"
#include "volume/mesh_topology/mesh_tree.h"

namespace isoloop {
namespace {

constexpr std::uint64_t bytes_per_triangle =
    edge_bytes_per_triangle + shell_bytes_per_triangle + tree_bytes_per_triangle;

std::string number_of(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// Why the mesh's edges make no closed surfaces; empty if they do.
std::string fault_of_edges(const std::vector<MeshEdge>& edges) {
  std::size_t open = 0;
  std::size_t crowded = 0;
  for_each_edge(edges, [&](std::span<const MeshEdge> sides) {
    open += sides.size() % 2;
    crowded += sides.size() > 2 ? 1 : 0;
  });
  if (open > 0) return "it is open";
  if (crowded == 0) return {};
  return "parts of it touch: " + number_of(crowded, "edge has", "edges have") +
         " more than two faces";
}

/// Adds up what the shells bound.
void add_shells(const Shells& shells, const std::vector<WindingAt>& windings, MeshCounts& counts) {
  Betti betti;
  for (std::size_t s = 0; s < shells.list.size(); ++s) {
    const std::int64_t euler = shells.list[s].euler;
    if (euler > 2 || euler % 2 != 0) {  // no closed surface without crossings is like that
      counts.unknown = "its shells cannot be told apart";
      return;
    }
    const bool is_solid_around = windings[s].around != 0;
    const bool is_solid_within = windings[s].within != 0;
    if (is_solid_around == is_solid_within) {
      ++counts.swallowed;
      continue;
    }
    ++(is_solid_within ? betti.b0 : betti.b2);
    betti.b1 += (2 - euler) / 2;
  }
  counts.shells = shells.list.size();
  counts.betti = betti;
}

}  // namespace

MeshCounts count_mesh(const Mesh& mesh, double near, std::uint64_t max_bytes) {
  MeshCounts counts{.triangles = mesh.triangles.size()};
  const auto unknown = [&](const std::string& why) {
    counts.unknown = why;
    return counts;
  };
  if (mesh.triangles.size() > max_bytes / bytes_per_triangle) {
    return unknown("that would take more memory than the limit");
  }
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max() / 3) {
    return unknown("it has more triangles than can be numbered");
  }
  std::vector<MeshEdge> edges = edges_of(mesh);
  if (const std::string fault = fault_of_edges(edges); !fault.empty()) return unknown(fault);
  const Shells shells = shells_of(mesh, edges);
  edges = {};
  if (shells.pinches > 0) {
    return unknown("parts of it touch at " + number_of(shells.pinches, "corner", "corners"));
  }
  const MeshTree tree(mesh, shells.of_triangle);
  const std::optional<std::size_t> pairs = meeting_pairs(mesh, tree);
  if (!pairs) return unknown("its triangles lie too close together to be told apart");
  if (*pairs > 0) {
    return unknown("it crosses or touches itself in " +
                   number_of(*pairs, "pair of triangles", "pairs of triangles"));
  }
  const auto windings = windings_at(mesh, shells, tree);
  if (!windings) return unknown("its shells lie too close together to be told apart");
  add_shells(shells, *windings, counts);
  if (counts.betti) counts.gap = least_gap(mesh, shells, tree, near);
  return counts;
}

std::string betti_text(const Betti& betti) {
  return "b0 " + std::to_string(betti.b0) + ", b1 " + std::to_string(betti.b1) + ", b2 " +
         std::to_string(betti.b2);
}

}  // namespace isoloop
