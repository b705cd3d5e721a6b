// What a repair did, for people and for programs.
#pragma once

#include <ostream>

#include "tools/runs/run_result.h"

namespace isoloop {

/// Counts before and after, one row for each removal, and what changed.
void write_repair_table(std::ostream& out, const RepairRun& run);

/// The same as JSON, schema isoloop-repair/1; docs/manual.md has the fields.
void write_repair_json(std::ostream& out, const RepairRun& run);

}  // namespace isoloop
