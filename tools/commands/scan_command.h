// The subcommand `isoloop scan`.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds the subcommand; parsing it counts components, tunnels and cavities at many iso values.
/// Throws the errors of core/base/errors.h while it runs; then nothing has been written.
void add_scan_command(CLI::App& app);

}  // namespace isoloop
