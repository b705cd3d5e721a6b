// An analysis and all that it was made with, for what goes on from the loops.
#pragma once

#include <memory>

#include "core/analysis/analysis.h"
#include "core/complex/grid_complex.h"
#include "core/complex/octree_complex.h"
#include "core/cube/voxel_sides.h"
#include "core/engines/dual_pass.h"
#include "core/loops/certificate.h"
#include "core/loops/killing_border.h"
#include "core/octree/octree.h"
#include "core/surface/edge_index.h"
#include "core/z2/z2_basis.h"

namespace isoloop {

/// One side of M with its labels, the borders of the surfaces that these span, and the borders'
/// classes, which say what each loop closes.
struct WorkedSide {
  std::unique_ptr<GridComplex> complex;
  std::unique_ptr<OctreeComplex> octree;  // where the pass ran on one: its numbers are those of it
  DualPass pass;
  KillingBorders borders;
  Z2Basis border_classes;
};

/// work(the complex that the pass ran on).
template <class Work>
auto on_complex(const WorkedSide& side, const Work& work) {
  return side.octree ? work(*side.octree) : work(*side.complex);
}

/// Where M has no loops there are no complexes. The sides of the voxels and the cut edges stay
/// where they are in memory: the complexes refer to them.
struct Workings {
  std::unique_ptr<const VoxelSides> sides;
  std::unique_ptr<const EdgeIndex> edges;
  std::unique_ptr<const Octree> octree;  // or none
  WorkedSide inside;
  WorkedSide outside;
  SurfaceClasses classes;
  Analysis analysis;

  /// The number of a grid vertex among those of the complex.
  std::uint32_t vertex_at(std::uint32_t grid_vertex) const {
    return octree ? octree->vertex_at(grid_vertex) : grid_vertex;
  }

  const WorkedSide& on(Side side) const { return side == Side::inside ? inside : outside; }
};

/// analyze(), with its workings.
Workings work_out_loops(const AnyGridView& grid, const IsoLevel& level,
                        const AnalysisOptions& options = {});

}  // namespace isoloop
