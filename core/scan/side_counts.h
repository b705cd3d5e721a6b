// The components of one side of M at all iso values, by union-find over the voxels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/grid/lattice.h"
#include "core/scan/volume_sweep.h"

namespace isoloop {

/// Items by step: list[first[s]] ... list[first[s + 1] - 1].
struct ByStep {
  std::vector<std::uint32_t> list;
  std::vector<std::size_t> first;
};

/// The vertices of the grid by rank.
ByStep vertices_by_step(const RankedGrid& grid);

/// Components of one side, by step.
struct SideCounts {
  std::vector<std::int64_t> all;
  std::vector<std::vector<std::int64_t>> large;  // by size, then by step
  std::vector<std::int64_t> largest;             // voxels
};

/// Vertices come in as the side grows: the inside from the last step to the first, the outside the
/// other way. What lies round the grid counts as large. `vertices`: vertices_by_step(grid).
SideCounts component_counts(const RankedGrid& grid, const ByStep& vertices,
                            const std::vector<Join>& joins, Side side,
                            std::span<const std::int64_t> sizes);

}  // namespace isoloop
