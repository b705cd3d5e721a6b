// The subcommand `isoloop loops`.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds the subcommand; parsing it finds, proves and reports the loops of an iso-surface.
/// Throws the errors of core/base/errors.h while it runs; then nothing has been written.
void add_loops_command(CLI::App& app);

}  // namespace isoloop
