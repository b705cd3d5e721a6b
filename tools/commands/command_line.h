// The command line of isoloop, from arguments to exit code.
#pragma once

#include <string>
#include <vector>

namespace isoloop {

/// Runs the subcommand that `arguments` (without the program's name) ask for and returns the exit
/// code of tools/words/exit_code.h. Never throws: an error is one line on standard error.
int run_command_line(const std::vector<std::string>& arguments) noexcept;

}  // namespace isoloop
