// M: the oriented, triangulated iso-surface, with its edge graph.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/cube/voxel_sides.h"
#include "core/surface/edge_graph.h"
#include "core/surface/edge_index.h"
#include "isoloop/surface.h"

namespace isoloop {

/// The mesh with what it was made from. Its points are first those that lie strictly within one
/// grid edge each, numbered by EdgeIndex; then, strictly within a cube each, the rings round
/// tunnels (ring_vertex()).
struct Surface : SurfaceMesh {
  /// The grid edge, of the lattice of the sides, that each of the first vertices cuts.
  std::vector<std::uint32_t> grid_edges;
  /// The cube of the lattice that holds each triangle; ascending.
  std::vector<std::uint32_t> triangle_cubes;
  /// One patch of a cube that is a disc is one polygon; its triangles are consecutive. Where M is
  /// closed, grid_edges - polygons = -euler: four segments on faces meet at each vertex on a grid
  /// edge.
  std::int64_t polygons = 0;
  /// Edges of one triangle only, directed as in it; none where M is closed.
  std::vector<std::array<std::uint32_t, 2>> border_edges;
  /// Edge graph: each edge of M in both directions, with its length.
  EdgeGraph graph;

  std::int64_t euler() const;
  std::int64_t genus() const;
  std::int64_t betti1() const;  // rank of H1(M): 2 genus() where M is closed
};

/// The number of vertex `first_ring_vertex + i` of the cut at sides.tunnels[tunnel].
inline std::uint32_t ring_vertex(const EdgeIndex& edges, std::size_t tunnel, int i) {
  return edges.count() + static_cast<std::uint32_t>(ring_size * tunnel) +
         static_cast<std::uint32_t>(i);
}

/// Cuts the iso-surface out of `grid`. Combinatorics depend on `sides` alone; a vertex sits where
/// linear interpolation puts it, kept in [1/1000, 999/1000] of its grid edge (farther off its ends
/// beyond voxel 8191, as single precision asks for), and at 1/2 on edges that lead out of the grid.
/// The ring round a tunnel: see tunnel_ring(). `sides` must come from classify(grid, level),
/// `edges` from `sides`. Counts need no graph: without it Surface::graph stays empty. Throws
/// LimitExceeded where vertices or triangle corners outgrow 32-bit indices, and SelfCheckFailed
/// where an edge's length is not finite or not above 0.
Surface extract_surface(const AnyGridView& grid, const IsoLevel& level, const VoxelSides& sides,
                        const EdgeIndex& edges, bool with_graph = true);

/// Position in units of length (voxel index times spacing).
Vec3 scaled_point(const Surface& surface, std::uint32_t vertex);

/// Between two places in voxel indices, in units of length.
double scaled_distance(const Surface& surface, const Vec3& p, const Vec3& q);

}  // namespace isoloop
