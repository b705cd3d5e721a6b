// The sizes of one side's pieces and edges within an octree.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/complex/complex.h"
#include "core/complex/octree_complex.h"
#include "core/octree/octree.h"
#include "core/sizes/geodesic_size.h"
#include "core/surface/edge_index.h"
#include "core/surface/surface.h"

namespace isoloop {

/// As EdgeSizes, of minimal edges, and of the sides of faces that are two edges long, by the number
/// of their first edge: each edge jumps less far round the medial axis than the side.
struct OctreeEdgeSizes {
  SparseSizes by_edge;                 // of a cut edge: of its inside half
  SparseSizes by_side;                 // of two edges
  std::vector<float> of_outside_half;  // by vertex of M: of its grid edge's outside half

  std::uint64_t bytes() const {
    return by_edge.bytes() + by_side.bytes() + of_outside_half.size() * sizeof(float);
  }
};

/// See geodesic_sizes(). `closest`: vertices of M by vertex of the octree.
OctreeEdgeSizes octree_edge_sizes(const Octree& octree, const EdgeIndex& edges,
                                  const Surface& surface, std::span<const std::uint32_t> closest,
                                  GeodesicMode mode);

/// Reads them off those. Keeps references: all three must outlive it.
class OctreeSizes {
 public:
  OctreeSizes(const OctreeComplex& complex, const EdgeIndex& edges, const OctreeEdgeSizes& sizes)
      : complex_(complex), edges_(edges), sizes_(sizes) {}

  float of_piece(std::uint32_t piece) const;

  /// Of an interior edge, or of its half on this side.
  float of_edge(std::uint32_t edge) const {
    return complex_.side() == Side::outside && complex_.octree().is_edge_cut(edge / 3, edge % 3)
               ? sizes_.of_outside_half[edges_.vertex_on(complex_.grid_edge(edge))]
               : sizes_.by_edge[edge];
  }

 private:
  const OctreeComplex& complex_;
  const EdgeIndex& edges_;
  const OctreeEdgeSizes& sizes_;
};

/// Leaves end at the first plane of the next layer: the faces in it are all that they touch there.
template <class Visit>
void for_each_sized_beside(const OctreeComplex& complex, const OctreeSizes& sizes,
                           std::uint32_t layer, const Visit& visit) {
  complex.for_each_piece_in_first_plane(
      layer, [&](std::uint32_t piece) { visit(piece, sizes.of_piece(piece)); });
}

static_assert(Sizes<OctreeSizes>);

}  // namespace isoloop
