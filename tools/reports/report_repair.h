// What a repair did, for people and for programs.
#pragma once

#include <ostream>
#include <string>

#include "core/repair/repair.h"
#include "tools/runs/run_result.h"

namespace isoloop {

/// A run of `repair`: `run` says what was read and how, and what it cost.
struct RepairRun {
  RunResult run;
  Repair repair;
  std::string output;  // the file written; empty on a dry run
};

/// Counts before and after, one row for each removal, and what changed.
void write_repair_table(std::ostream& out, const RepairRun& result);

/// The same as JSON, schema isoloop-repair/1; docs/manual.md has the fields.
void write_repair_json(std::ostream& out, const RepairRun& result);

}  // namespace isoloop
