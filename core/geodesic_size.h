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
/// straight links cut corners: 0.99 times the exact size on the mean on a torus, 0.85 to 0.89 on
/// smoothed noise, 0.72 beyond 64 voxels on a gyroid, each with a standard deviation of about 0.1.
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
