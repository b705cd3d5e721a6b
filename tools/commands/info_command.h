// The subcommand `isoloop info`.
#pragma once

#include <ostream>
#include <string>

#include "core/base/errors.h"
#include "tools/flags/input_flags.h"
#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds the subcommand; parsing it reads a volume and prints what it is to standard output.
/// Throws InvalidArgument, InvalidInput and LimitExceeded while it runs.
void add_info_command(CLI::App& app);

/// Where `error` says that the folder holds several series and none was chosen: their list, with
/// `command`, the words of a command without --series, for each. Else false.
bool write_series(std::ostream& out, const VolumeFlags& flags, const InvalidArgument& error,
                  const std::string& command);

/// What a volume is, a line for each thing.
void write_info(std::ostream& out, const VolumeFlags& flags, const Volume& volume);

}  // namespace isoloop
