// A grid at a lower resolution: what is narrower than its blocks no longer shows.
#pragma once

#include <cstdint>
#include <vector>

#include "isoloop/grid.h"

namespace isoloop {

/// Means over blocks of voxels, those at the far borders smaller.
struct Blocks {
  std::vector<float> values;  // first axis fastest; infinite voxels count as 1e30
  Index3 dims{};
};

/// Blocks of `side` voxels along each axis, at least 1, of a grid without NaN. In parallel.
Blocks means_of_blocks(const AnyGridView& grid, std::int64_t side);

}  // namespace isoloop
