// The subcommand `isoloop view`.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds the subcommand; parsing it finds and proves the loops and writes a page to look at them.
/// Throws the errors of core/base/errors.h while it runs; then nothing has been written.
void add_view_command(CLI::App& app);

}  // namespace isoloop
