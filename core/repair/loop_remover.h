// Takes away one handle or tunnel by changing voxels, and proves that it did that and no more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/workings.h"
#include "core/base/memory_budget.h"
#include "core/complex/grid_complex.h"
#include "core/grid/grid.h"
#include "core/loops/loops.h"
#include "core/repair/membrane.h"
#include "core/repair/voxel_values.h"
#include "core/z2/label.h"
#include "isoloop/repair.h"

namespace isoloop {

/// A loop as a removal sees it: its class, and where it runs.
struct LoopSite {
  LoopKind kind = LoopKind::handle;
  GeneratorSet other;                // its class in the homology of the other side (SplitClass)
  GeneratorSet crossing;             // the handles (or tunnels) that it closes, by generator
  std::vector<std::uint32_t> edges;  // grid edges of the lattice that its vertices lie on
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

/// How often two loops of different kinds cross on M, modulo 2.
bool cross_oddly(const LoopSite& a, const LoopSite& b);

/// Removes loops of one analysis, one after the other. Handles are cut along a membrane within I,
/// tunnels filled along one within O. A change counts if the genus drops by one and M has as many
/// components, of which as many bound cavities, as before.
class LoopRemover {
 public:
  /// Keeps references. `values`: the voxels that `workings` come from, to be changed by apply().
  /// `max_bytes`: for the count after a change, beside them; over it, propose() throws
  /// LimitExceeded.
  LoopRemover(const Workings& workings, const IsoLevel& level, VoxelValues& values,
              std::uint64_t max_bytes = unlimited_bytes);

  /// A change of few voxels that removes the loop: a thin membrane near it (MembraneFinder), tried
  /// in several places, with what it severs where that alone fails; else the surface that the
  /// labels span across the handle or tunnel, to the letter, and dilated; else a voxel beside a
  /// short loop that keeps its side. Nothing if none of them passes.
  std::optional<std::vector<VoxelChange>> propose(const LoopSite& loop);

  /// Makes a change that propose() gave, with no other change since.
  void apply(const std::vector<VoxelChange>& change);

 private:
  MembraneFinder<GridComplex>& finder(Side side);
  std::vector<std::uint32_t> reaches_for(double steps) const;
  std::optional<std::vector<VoxelChange>> thin_change(Side side, const MembraneQuery& query,
                                                      std::vector<std::uint32_t> reaches);
  std::optional<std::vector<VoxelChange>> passing(Side side,
                                                  const std::vector<std::uint32_t>& vertices);
  std::vector<std::uint32_t> dilated(Side side, const std::vector<std::uint32_t>& vertices) const;
  std::optional<std::vector<VoxelChange>> values_for(Side side,
                                                     const std::vector<std::uint32_t>& vertices,
                                                     int style) const;
  std::optional<std::vector<VoxelChange>> shift(const LoopSite& loop);
  std::vector<std::size_t> voxels_near(std::span<const std::uint32_t> vertices) const;
  double greatest_magnitude(const std::vector<std::size_t>& voxels) const;
  std::optional<double> usual_magnitude(const std::vector<std::size_t>& voxels, Side side) const;
  bool removes_one(const std::vector<VoxelChange>& change);
  std::size_t voxel_of(std::uint32_t vertex) const;
  double magnitude_of(std::size_t voxel) const;  // distance from iso; unit of the values
  bool is_inside(std::size_t voxel) const;

  const Workings& workings_;
  IsoLevel level_;
  VoxelValues& values_;
  std::uint64_t max_bytes_;
  std::int64_t genus_;
  Betti betti_;
  std::vector<bool> changed_;  // by lattice vertex: to the other side, by apply()
  std::vector<bool> fixed_;    // by lattice vertex: no voxel of the grid
  std::optional<MembraneFinder<GridComplex>> inside_;
  std::optional<MembraneFinder<GridComplex>> outside_;
};

}  // namespace isoloop
