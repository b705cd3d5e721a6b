// `isoloop measure`, which no help names: one run of `isoloop bench`.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

/// Finds the loops of one shape or file and prints what that took, as text_of(Measurement), to
/// standard output.
void add_measure_command(CLI::App& app);

}  // namespace isoloop
