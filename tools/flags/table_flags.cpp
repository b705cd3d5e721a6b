#include "tools/flags/table_flags.h"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "core/base/errors.h"
#include "tools/words/flag_checks.h"

namespace isoloop {
namespace {

constexpr std::size_t rows_on_a_terminal = 30;

}  // namespace

void add_summary_flag(CLI::App& command, TableFlags& flags) {
  command.add_flag("--summary", flags.summary, "print one line of NAME=VALUE, for scripts");
}

void add_table_flags(CLI::App& command, TableFlags& flags) {
  want_whole_number(
      command
          .add_option("--top", flags.top,
                      "rows of loops in the table, the largest first; 0 is all (default: 30 on a "
                      "terminal, elsewhere all, in the order of their ids)")
          ->type_name("N"),
      0);
  add_summary_flag(command, flags);
}

void check_table_flags(const TableFlags& flags, bool uses_stdout) {
  if (flags.summary && flags.top) {
    throw InvalidArgument(
        "--top does not go with --summary, which is one line in place of the table");
  }
  if (!uses_stdout) return;
  if (flags.summary) {
    throw InvalidArgument(
        "--summary goes to standard output, and so does a report; give that a file");
  }
  if (flags.top) {
    throw InvalidArgument("--top is for the table, which a report on standard output replaces");
  }
}

std::size_t most_rows(const TableFlags& flags) {
  if (flags.top) return *flags.top;
  return isatty(STDOUT_FILENO) == 1 ? rows_on_a_terminal : 0;
}

}  // namespace isoloop
