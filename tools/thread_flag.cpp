#include "tools/thread_flag.h"

#include <CLI/CLI.hpp>

namespace isoloop {

void add_thread_flag(CLI::App& command, int& threads) {
  command
      .add_option("--threads", threads,
                  "threads to use (default: one for each core; fewer where memory is short); the "
                  "result does not depend on it")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
}

}  // namespace isoloop
