// The subcommand `isoloop generate`.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds the subcommand; parsing it writes a solid of known topology as a volume.
/// Throws InvalidArgument, InvalidInput and LimitExceeded while it runs; then nothing has been
/// written.
void add_generate_command(CLI::App& app);

}  // namespace isoloop
