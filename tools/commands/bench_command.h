// `isoloop bench`: what the search for loops costs, how that grows, and how it spreads; and
// `isoloop measure`, which no help names: one run of it.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

void add_bench_command(CLI::App& app);

/// Finds the loops of one shape or file and prints what that took, as text_of(Measurement), to
/// standard output.
void add_measure_command(CLI::App& app);

}  // namespace isoloop
