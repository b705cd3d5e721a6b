// The subcommand `isoloop repair`.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds the subcommand; parsing it writes a volume without the handles and tunnels that were asked
/// for. Throws the errors of core/base/errors.h while it runs; then nothing has been written.
void add_repair_command(CLI::App& app);

}  // namespace isoloop
