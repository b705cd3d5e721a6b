// The subcommand `isoloop demo`.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds the subcommand; parsing it makes the built-in engine block, finds its loops, and writes it
/// and a page into a folder. Throws the errors of core/base/errors.h while it runs.
void add_demo_command(CLI::App& app);

}  // namespace isoloop
