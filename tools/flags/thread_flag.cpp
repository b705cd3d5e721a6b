#include "tools/flags/thread_flag.h"

#include <CLI/CLI.hpp>

#include "tools/words/flag_checks.h"

namespace isoloop {

void add_thread_flag(CLI::App& command, int& threads) {
  want_whole_number(
      command
          .add_option("--threads", threads,
                      "threads to use (default: one for each core; fewer where memory is short); "
                      "the result does not depend on it")
          ->type_name("N"),
      1, 1024);
}

}  // namespace isoloop
