// The counts at many iso values, as tables.
#pragma once

#include <ostream>

#include "tools/runs/run_result.h"

namespace isoloop {

/// One row for each plateau (the iso values from one to another at which the counts of what is
/// large are the same), the stable ones marked, and the proposed iso value.
void write_scan_table(std::ostream& out, const ScanRun& run);

/// One header line, then one line for each iso value: iso, b0, b1, b2, euler (of M), genus,
/// inside_voxels, large_b0, large_b1, large_b2, plateau (its number, from 1), meaningful (1 or 0).
void write_scan_csv(std::ostream& out, const ScanRun& run);

/// One JSON object, schema "isoloop/1": the rows as "scan", "plateaus", "ignored_below", and
/// "proposed_iso", "proposed_by" (plateau or otsu), "otsu_iso", "valley_iso", each null where there
/// is none.
void write_scan_json(std::ostream& out, const ScanRun& run);

}  // namespace isoloop
