// The counts at many iso values, as tables.
#pragma once

#include <ostream>

#include "tools/runs/run_result.h"

namespace isoloop {

/// One row for each plateau (the iso values from one to another at which all counts are the same),
/// the widest meaningful ones marked, and the proposed iso value.
void write_scan_table(std::ostream& out, const ScanRun& run);

/// One header line, then one line for each iso value: iso, b0, b1, b2, euler (of M), genus,
/// inside_voxels, plateau (its number, from 1), meaningful (1 or 0).
void write_scan_csv(std::ostream& out, const ScanRun& run);

/// One JSON object, schema "isoloop/1": the rows as "scan", and "plateaus" and "proposed_iso".
void write_scan_json(std::ostream& out, const ScanRun& run);

/// Numbers of the widest meaningful plateaus, the widest first, at most `most`.
std::vector<std::size_t> widest_plateaus(const IsoScan& scan, std::size_t most = 5);

}  // namespace isoloop
