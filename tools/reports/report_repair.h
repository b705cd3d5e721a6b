// What a repair did, for people and for programs.
#pragma once

#include <cstddef>
#include <ostream>

#include "tools/runs/run_result.h"

namespace isoloop {

/// Counts before and after, one row for each removal and one for each loop that is kept, and what
/// changed. With `most_rows` above 0 the rows of both are those of so many longest loops, these
/// first, and how many more there are is said.
void write_repair_table(std::ostream& out, const RepairRun& run, std::size_t most_rows = 0);

/// The same as JSON, schema isoloop-repair/1; docs/manual.md has the fields.
void write_repair_json(std::ostream& out, const RepairRun& run);

}  // namespace isoloop
