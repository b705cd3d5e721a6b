// The subcommand `isoloop count`.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds the subcommand; parsing it counts components, tunnels and cavities of an iso-surface.
/// Throws the errors of core/base/errors.h while it runs; then nothing has been written.
void add_count_command(CLI::App& app);

}  // namespace isoloop
