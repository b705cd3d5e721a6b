// What a change of few voxels does to the counts, told from its surroundings.
#pragma once

#include <cstdint>
#include <vector>

#include "core/repair/current_volume.h"
#include "core/repair/part_search.h"
#include "isoloop/repair.h"

namespace isoloop {

/// By how much each number grows.
struct ChangeEffect {
  std::int64_t euler = 0;          // Euler characteristic of M
  std::int64_t inside_parts = 0;   // components of I
  std::int64_t outside_parts = 0;  // components of O with what lies round the grid

  friend bool operator==(const ChangeEffect& a, const ChangeEffect& b) = default;
};

/// The effect of a change on the volume as it is, which is the same afterwards. `search`: of this
/// volume. `change`: no voxel twice; voxels of the lattice.
///
/// The cubes at the changed voxels are cut as before and as after. Their discs less the cut grid
/// edges are what M's Euler characteristic has of them. Parts of a side that these cubes join at
/// one of both times alone are followed through the grid.
/// The first is that of M's Euler characteristic alone, which looks no farther than the cubes.
std::int64_t euler_effect(const std::vector<VoxelChange>& change, CurrentVolume& volume);
ChangeEffect effect_of(const std::vector<VoxelChange>& change, CurrentVolume& volume,
                       PartSearch& search);

}  // namespace isoloop
