// The subcommand `isoloop scan`.
#pragma once

#include <optional>
#include <vector>

#include "core/progress.h"
#include "tools/cli_app.h"
#include "tools/run_result.h"

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
std::vector<double> scan_values(const ScanRange& range, const Volume& volume,
                                const ValueRange& voxels);

/// Fills run.scan, run.plateaus and run.proposed. `isos`: ascending.
void scan_run(RunResult& run, const std::vector<double>& isos, const Progress& progress);

/// Adds the subcommand; parsing it counts components, tunnels and cavities at many iso values.
/// Throws the errors of core/errors.h while it runs; then nothing has been written.
void add_scan_command(CLI::App& app);

}  // namespace isoloop
