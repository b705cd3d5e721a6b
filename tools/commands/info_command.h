// The subcommand `isoloop info`.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds the subcommand; parsing it reads a volume and prints what it is to standard output.
/// Throws InvalidArgument, InvalidInput and LimitExceeded while it runs.
void add_info_command(CLI::App& app);

}  // namespace isoloop
