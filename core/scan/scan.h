// The counts of the solid as functions of the iso value, all at once.
//
// b0 and b2 by union-find over the voxels in the order in which they enter the solid, and the
// outside: grid edges join when both ends are there, face diagonals while the face is joined, cells
// of a cube while a tunnel joins them. What is joined in a solid stays joined in a larger one. The
// Euler characteristic of M is a sum over cubes and grid edges, each constant between a few iso
// values (core/scan/cube_sweep.h). b1 follows from the three: b0 - b1 + b2 is half of it.
#pragma once

#include <span>
#include <vector>

#include "isoloop/grid.h"
#include "isoloop/scan.h"

namespace isoloop {

/// One row for each iso value, in their order: strictly ascending, finite. On the threads that the
/// caller has, whatever options.threads says. Takes about 16 bytes a
/// voxel, and 4 for each face whose corners' values can alternate. Throws InvalidArgument (iso
/// values, dimensions), InvalidInput (NaN in the grid), LimitExceeded over max_lattice_vertices or
/// where it takes more than options.max_bytes, SelfCheckFailed where the counts contradict each
/// other.
std::vector<ScanRow> scan_topology(const AnyGridView& grid, std::span<const double> iso_values,
                                   const ScanOptions& options = {});

}  // namespace isoloop
