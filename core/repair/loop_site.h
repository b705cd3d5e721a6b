// A loop as a removal sees it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/analysis/workings.h"
#include "core/grid/grid.h"
#include "core/grid/lattice.h"
#include "core/z2/label.h"
#include "isoloop/loop.h"

namespace isoloop {

/// Its class, and where it runs.
struct LoopSite {
  LoopKind kind = LoopKind::handle;
  GeneratorSet other;                // its class in the homology of the other side (SplitClass)
  GeneratorSet crossing;             // the handles (or tunnels) that it closes, by generator
  std::vector<std::uint32_t> edges;  // grid edges of the lattice that its vertices lie on
  std::vector<std::uint32_t> cubes;  // those in which its other vertices lie, round tunnels
  double length = 0.0;               // unit of the spacing
  double steps = 0.0;                // its length in voxel indices, whatever the spacing
  /// It does not bound on M's components one by one. A disc has its border on one component, so no
  /// cut or fill along a disc removes the loop: others would join two components or part one.
  bool spans_components = false;
};

/// Where a loop of the analysis runs.
LoopSite site_of(const Workings& workings, const Loop& loop);

/// Where the voxel of a grid of `dims` lies in the lattice, which must hold it.
std::uint32_t vertex_of(std::size_t voxel, const Index3& dims, const Lattice& lattice);

/// The loop's class in the homology of the side in which it does not bound, numbered as class_of()
/// does.
GeneratorSet joint_class(const Workings& workings, const LoopSite& site);

}  // namespace isoloop
