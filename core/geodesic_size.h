// g(e): how far apart, along M, the surface vertices closest to the ends of an edge of K are.
#pragma once

#include <cstdint>
#include <vector>

#include "core/edge_index.h"
#include "core/sides.h"
#include "core/surface.h"

namespace isoloop {

/// exact: Dijkstra on M for every pair, the paper's definition to the letter.
/// hierarchy: exact up to five voxels; beyond that on ever coarser clusters of M's vertices, whose
/// straight links cut corners about as much as they zigzag: 0.97 to 1.05 times the exact size on
/// the mean on a torus, a plate, a lattice, a gyroid and smoothed noise, with a standard deviation
/// of about 0.12. Beyond 64 voxels on smoothed noise 1.10.
enum class GeodesicMode { exact, hierarchy };

/// Sizes of K's edges, unit of the spacing; infinite where the ends' closest vertices lie on
/// different components of M, 0 where they coincide.
struct EdgeSizes {
  std::vector<float> by_edge;          // by grid edge; of a cut edge: of its inside half
  std::vector<float> of_outside_half;  // by vertex of M: of its grid edge's outside half
};

/// g of Dey, Li, Sun, Cohen-Steiner (SIGGRAPH 2008), section 4. `closest`: by lattice vertex.
EdgeSizes geodesic_sizes(const Sides& sides, const EdgeIndex& edges, const Surface& surface,
                         const std::vector<std::uint32_t>& closest, GeodesicMode mode);

}  // namespace isoloop
