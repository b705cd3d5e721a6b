// --threads: the same in every subcommand that has it.
#pragma once

#include "core/base/threads.h"
#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds --threads; 0 stands for one thread for each core. `threads` must outlive the parse.
void add_thread_flag(CLI::App& command, int& threads);

/// Runs work() on as many threads as --threads says, and returns its result.
template <class Work>
auto on_threads(int threads, const Work& work) {
  return with_threads(threads > 0 ? threads : static_cast<int>(thread_count()), work);
}

}  // namespace isoloop
