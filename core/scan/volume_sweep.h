// All cubes of a grid at all iso values: what they add to M's Euler characteristic, and the voxels
// that they join beyond grid edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/grid/lattice.h"
#include "core/scan/cube_sweep.h"
#include "isoloop/grid.h"
#include "isoloop/scan.h"

namespace isoloop {

/// The grid with one outside layer round it, and at which steps each vertex is inside.
struct RankedGrid {
  Lattice lattice;
  std::vector<Step> rank;    // inside at the steps before; 0 in the outside layer
  std::vector<double> isos;  // by step
};

/// Two vertices that are joined at all steps on one side of `step`.
struct Join {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  Step step = 0;
};

/// Joins other than those along grid edges: of the inside at the steps up to `step`, of the outside
/// from `step` on.
struct Joins {
  std::vector<Join> inside;
  std::vector<Join> outside;
};

/// Sums over cubes, as differences from one step to the next.
struct StepSums {
  std::vector<std::int64_t> discs;
  std::vector<std::int64_t> cut_edges;

  explicit StepSums(std::size_t steps) : discs(steps + 1), cut_edges(steps + 1) {}

  void add(const StepSums& other) {
    for (std::size_t i = 0; i < discs.size(); ++i) {
      discs[i] += other.discs[i];
      cut_edges[i] += other.cut_edges[i];
    }
  }
};

struct VolumeSweep {
  RankedGrid ranked;
  StepSums sums;  // over all cubes
  Joins joins;
};

/// Throws InvalidArgument (dimensions), InvalidInput (NaN in the grid), LimitExceeded over
/// max_lattice_vertices or where a scan takes more than options.max_bytes.
VolumeSweep sweep_volume(const AnyGridView& grid, std::span<const double> iso_values,
                         const ScanOptions& options);

}  // namespace isoloop
