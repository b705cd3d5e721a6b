// Takes away one handle or tunnel by changing voxels, and proves that it did that and no more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/analysis/workings.h"
#include "core/complex/grid_complex.h"
#include "core/grid/grid.h"
#include "core/loops/loops.h"
#include "core/repair/current_volume.h"
#include "core/repair/loop_site.h"
#include "core/repair/membrane.h"
#include "core/repair/part_search.h"
#include "core/repair/voxel_values.h"
#include "core/z2/label.h"
#include "isoloop/repair.h"

namespace isoloop {

/// What is tried for a loop.
enum class Effort {
  few_voxels,  // one or two beside it, which remove it for sure
  membranes,   // more of them, which do so too
  across,      // the same for loops of the other kind that cross it
  any          // both, and what may turn out to spoil other loops
};

/// Removes loops of one analysis, one after the other. Handles are cut along a membrane within I,
/// tunnels filled along one within O. A change counts if the genus drops by one and M has as many
/// components, of which as many bound cavities, as before.
class LoopRemover {
 public:
  /// Keeps references. `values`: the voxels that `workings` come from, to be changed by apply().
  /// Takes bytes_per_vertex for each of the lattice's.
  LoopRemover(const Workings& workings, const IsoLevel& level, VoxelValues& values);

  static constexpr std::uint64_t bytes_per_vertex = 21;

  /// A change that removes the loop. With Effort::few_voxels one or two voxels beside it, or one
  /// that keeps its side; then a thin membrane near it (MembraneFinder), tried in several places,
  /// with what it severs where that alone fails, then the surface that the labels span across the
  /// handle or tunnel, to the letter, and dilated. Nothing if none of them passes. Not
  /// for Effort::across.
  std::optional<std::vector<VoxelChange>> propose(const LoopSite& loop, Effort effort);

  /// Makes a change that propose() gave for the loop, with no other change since.
  void apply(const LoopSite& loop, const std::vector<VoxelChange>& change);

 private:
  MembraneFinder<GridComplex>& finder(Side side);
  std::vector<std::uint32_t> reaches_for(double steps) const;
  std::optional<std::vector<VoxelChange>> small_change(const LoopSite& loop,
                                                       const std::vector<std::uint32_t>& spanned);
  std::optional<std::vector<std::uint32_t>> earlier_near(
      const std::vector<std::uint32_t>& vertices) const;
  bool removes_surely(const LoopSite& loop, const std::vector<std::uint32_t>& vertices,
                      const std::vector<VoxelChange>& change);
  bool lies_within(const LoopSite& loop, const std::vector<std::uint32_t>& cubes) const;
  std::optional<std::vector<VoxelChange>> thin_change(const LoopSite& loop,
                                                      const MembraneQuery& query, bool surely);
  std::optional<std::vector<VoxelChange>> passing(const LoopSite& loop,
                                                  const std::vector<std::uint32_t>& vertices,
                                                  bool surely);
  std::vector<std::uint32_t> dilated(Side side, const std::vector<std::uint32_t>& vertices) const;
  std::optional<std::vector<VoxelChange>> values_for(Side side,
                                                     const std::vector<std::uint32_t>& vertices,
                                                     int style) const;
  std::vector<std::uint32_t> vertices_beside(const LoopSite& loop, Side side) const;
  std::optional<std::vector<VoxelChange>> shift(const LoopSite& loop, bool surely);
  std::vector<std::size_t> voxels_near(std::span<const std::uint32_t> vertices) const;
  double greatest_magnitude(const std::vector<std::size_t>& voxels) const;
  std::optional<double> usual_magnitude(const std::vector<std::size_t>& voxels, Side side) const;
  bool removes_one(const std::vector<VoxelChange>& change);
  std::size_t voxel_of(std::uint32_t vertex) const;
  double magnitude_of(std::size_t voxel) const;  // distance from iso; unit of the values
  bool is_inside(std::size_t voxel) const;

  /// A change that was made.
  struct Earlier {
    std::vector<std::uint32_t> vertices;
    GeneratorSet removed;  // joint_class() of its loop
    bool is_sure = false;  // removes_surely()
  };

  const Workings& workings_;
  IsoLevel level_;
  VoxelValues& values_;
  CurrentVolume volume_;
  PartSearch search_;
  std::vector<bool> changed_;     // by lattice vertex: to the other side, by apply()
  std::vector<Earlier> earlier_;  // by apply()
  std::unordered_map<std::uint32_t, std::uint32_t> changer_;  // of a vertex: the last of these
  std::vector<bool> fixed_;  // by lattice vertex: no voxel of the grid
  std::optional<MembraneFinder<GridComplex>> inside_;
  std::optional<MembraneFinder<GridComplex>> outside_;
};

}  // namespace isoloop
