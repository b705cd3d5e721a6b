// Which iso values a scan looks at, and what it finds there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
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

/// What does not break a plateau; neither is set: isoloop chooses.
struct IgnoredSize {
  std::optional<std::int64_t> voxels{};
  std::optional<double> share{};  // of the largest component, above 0 and below 1
};

/// From "64" or "0.1%"; empty: neither. Throws InvalidArgument.
IgnoredSize parse_ignored_size(std::string_view text);

/// The iso values, ascending: evenly spaced, for volumes of integers rounded to integers. All
/// integers of the range where it has no more than 1024 and no number is asked for. Throws
/// InvalidArgument where the range is empty or not finite.
std::vector<double> scan_values(const ScanRange& range, const AnyGridView& grid,
                                const ValueRange& voxels);

/// The counts at `isos`, which ascend, and the iso value that they propose; none for label maps.
Scan scan_of(const RunInput& run, const std::vector<double>& isos, const Progress& progress,
             const IgnoredSize& ignored = {});

/// "the middle of the most stable plateau, 52 to 94", "Otsu's value, as no plateau is stable; the
/// valley of the histogram is at 64": what the proposed value is. There must be one.
std::string proposal_text(const Scan& scan);

/// Why scans propose nothing for the volume: its voxels are labels. Empty if they are not.
std::string labels_text(const RunInput& run);

}  // namespace isoloop
