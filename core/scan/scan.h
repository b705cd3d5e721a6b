// The counts of the solid as functions of the iso value, all at once.
//
// b0 and b2 by union-find over the voxels in the order in which they enter the solid, and the
// outside: grid edges join when both ends are there, face diagonals while the face is joined, cells
// of a cube while a tunnel joins them. What is joined in a solid stays joined in a larger one. The
// Euler characteristic of M is a sum over cubes and grid edges, each constant between a few iso
// values (core/scan/cube_sweep.h). b1 follows from the three: b0 - b1 + b2 is half of it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "isoloop/grid.h"
#include "isoloop/scan.h"

namespace isoloop {

/// One row for each iso value, in their order: strictly ascending, finite. On the threads that the
/// caller has, whatever options.threads says. Takes about 24 bytes a voxel, and 4 for each face
/// whose corners' values can alternate. Throws InvalidArgument (iso values, dimensions),
/// InvalidInput (NaN in the grid), LimitExceeded over max_lattice_vertices or where it takes more
/// than options.max_bytes, SelfCheckFailed where the counts contradict each other.
std::vector<ScanRow> scan_topology(const AnyGridView& grid, std::span<const double> iso_values,
                                   const ScanOptions& options = {});

/// The same, and beside it what is large.
struct SizedScan {
  std::vector<ScanRow> rows;  // as those of scan_topology()
  /// By size, then by row: b0 and b2 of so many voxels or more.
  std::vector<std::vector<Betti>> large;
  std::vector<std::int64_t> largest;  // by row: voxels of the largest component
};

/// `sizes`: in voxels, each at least 1. Throws as scan_topology() does.
SizedScan scan_sizes(const AnyGridView& grid, std::span<const double> iso_values,
                     std::span<const std::int64_t> sizes, const ScanOptions& options = {});

}  // namespace isoloop
