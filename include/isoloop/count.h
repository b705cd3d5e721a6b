// Components, tunnels and cavities of a solid, without its loops, so fast.
#pragma once

#include <cstdint>
#include <vector>

#include "isoloop/grid.h"
#include "isoloop/run.h"
#include "isoloop/surface.h"

namespace isoloop {

/// Of the solid, and of its surface M.
struct Counts {
  Betti betti;  // components, tunnels and cavities
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  std::int64_t euler = 0;                    // vertices - edges + triangles
  std::int64_t genus = 0;                    // of all components together
  std::vector<SurfaceComponent> components;  // of M, in the order of their first vertex
};

/// What lies beyond the grid, and how much the count may take.
struct CountOptions {
  Boundary boundary = Boundary::closed;
  int threads = 0;                            // at most; 0: one for each core
  Progress progress{};                        // may be empty
  std::uint64_t max_bytes = unlimited_bytes;  // to hold beside the grid's voxels
};

/// Counts exactly: what is joined is decided without rounding. The same for any number of threads.
/// Throws InvalidArgument for a grid of another number of values than its dims say, a spacing that
/// is none, a NaN iso, and one voxel along an axis with an open boundary; InvalidInput where a
/// voxel is NaN, and LimitExceeded, before memory is taken, for more than options.max_bytes or more
/// voxels than 32-bit numbers tell apart.
Counts count(const AnyGridView& grid, const IsoLevel& level, const CountOptions& options = {});

}  // namespace isoloop
