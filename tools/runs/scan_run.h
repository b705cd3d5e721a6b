// Which iso values a scan looks at, and what it finds there.
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "tools/runs/run_result.h"

namespace isoloop {

/// Which iso values a scan looks at, as typed; unit of the voxel values.
struct ScanRange {
  std::optional<int> values;   // how many; unset: 256, or all integers of a small range
  std::optional<double> from;  // unset: the least voxel value
  std::optional<double> to;    // unset: the largest voxel value
};

/// The iso values, ascending: evenly spaced, for volumes of integers rounded to integers. All
/// integers of the range where it has no more than 1024 and no number is asked for. Throws
/// InvalidArgument where the range is empty or not finite.
std::vector<double> scan_values(const ScanRange& range, const AnyGridView& grid,
                                const ValueRange& voxels);

/// The counts at `isos`, which ascend, and the iso value that they propose.
IsoScan scan_of(const RunInput& run, const std::vector<double>& isos, const Progress& progress);

}  // namespace isoloop
