// How much of a result standard output shows.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <ostream>

#include "tools/words/cli_app.h"

namespace isoloop {

/// As typed.
struct TableFlags {
  std::optional<std::size_t> top;  // rows; 0: all
  bool summary = false;
};

/// Adds --summary. `flags` must outlive the parse.
void add_summary_flag(CLI::App& command, TableFlags& flags);

/// Adds --top and --summary. `flags` must outlive the parse.
void add_table_flags(CLI::App& command, TableFlags& flags);

/// Throws InvalidArgument where both flags are given, or one of them and a report `uses_stdout`, so
/// that there is no table.
void check_table_flags(const TableFlags& flags, bool uses_stdout);

/// Rows of loops in a table, the largest first: as --top says, otherwise 30 on a terminal and all
/// in their order, which is 0, elsewhere.
std::size_t most_rows(const TableFlags& flags);

}  // namespace isoloop
