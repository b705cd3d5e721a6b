// A run in one line of NAME=VALUE, for scripts: the names are those of the JSON.
#pragma once

#include <ostream>

#include "tools/runs/run_result.h"

namespace isoloop {

/// iso, b0, b1, b2, euler and genus.
void write_count_summary(std::ostream& out, const CountRun& run);

/// The same, then of each kind that is reported the number of its loops and their length together.
void write_loops_summary(std::ostream& out, const LoopsRun& run);

/// The proposed iso value, by what, and the counts there without what is set aside;
/// proposed_iso=none where nothing is proposed.
void write_scan_summary(std::ostream& out, const ScanRun& run);

/// The counts of the repaired volume, how many loops were removed and kept, and how many voxels
/// changed.
void write_repair_summary(std::ostream& out, const RepairRun& run);

}  // namespace isoloop
