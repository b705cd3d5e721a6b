// The whole of a scan: its counts, what is stable among them, and the iso value to look at first.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "isoloop/grid.h"
#include "isoloop/scan.h"

namespace isoloop {

/// As scan() in isoloop/scan.h says, on the threads that the caller has. Throws as
/// scan_topology() does, and InvalidArgument for sizes to ignore that make no sense.
Scan scan_and_propose(const AnyGridView& grid, std::span<const double> iso_values,
                      const ScanOptions& options = {});

/// Sizes that are set aside in turn, in voxels, in a grid of so many: 64, 512, 4096 where they are
/// at most a thousandth of it.
std::vector<std::int64_t> default_ignored_sizes(std::int64_t voxel_count);

}  // namespace isoloop
