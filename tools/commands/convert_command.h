// The subcommand `isoloop convert`.
#pragma once

#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds the subcommand; parsing it reads a volume and writes it to a file of another format. Throws
/// the errors of core/base/errors.h while it runs; then nothing has been written.
void add_convert_command(CLI::App& app);

}  // namespace isoloop
