// What `isoloop FILE` does.
#pragma once

#include <string>
#include <vector>

#include "tools/words/cli_app.h"

namespace isoloop {

/// Adds the subcommand, which no help lists; parsing it prints what `info` and `count` would, the
/// iso value that --iso auto takes if none is stated, and the commands to type next; of a folder of
/// several series their list, with a command for each. `typed`: the words after `isoloop`, which
/// those commands repeat. Throws as info and count do.
void add_overview_command(CLI::App& app, const std::vector<std::string>& typed);

}  // namespace isoloop
