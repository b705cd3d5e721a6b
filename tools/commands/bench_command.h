// `isoloop bench`: what the search for loops costs, how that grows, and how it spreads.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

void add_bench_command(CLI::App& app);

}  // namespace isoloop
