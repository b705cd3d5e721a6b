// --threads: the same in every subcommand that has it.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds --threads; 0 stands for one thread for each core. `threads` must outlive the parse.
void add_thread_flag(CLI::App& command, int& threads);

}  // namespace isoloop
