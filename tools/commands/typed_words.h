// What was typed, before the flags are parsed: what people mean by it, and what is no flag.
#pragma once

#include <string>
#include <vector>

#include "tools/words/cli_app.h"

namespace isoloop {

/// The name of the command that `isoloop FILE` runs.
inline constexpr const char* overview_name = "overview";

/// The words of a command that all know: nothing and "help" as "--help", "help count" and
/// "count --iso --help" as "count --help" (so with --help-all), "version", "-v" and "-V" as
/// "--version", and "FILE ..." where there is such a file as "overview FILE ...".
std::vector<std::string> understood(const std::vector<std::string>& typed,
                                    const std::vector<std::string>& commands);

/// Throws InvalidArgument where the first word is none of `commands`, with the nearest of `shown`.
void check_command(const std::vector<std::string>& typed, const std::vector<std::string>& commands,
                   const std::vector<std::string>& shown);

/// Throws InvalidArgument for the first word typed that looks like a flag of `command` and is none,
/// with the flag that may be meant.
void check_flags_are_known(const std::vector<std::string>& typed, const CLI::App& command);

/// Before help is printed: leaves flags that few need out of it in all commands of `app`, unless
/// `all`.
void group_rare_flags(CLI::App& app, bool all);

/// The word as a shell takes it: in quotes where it has to be.
std::string shell_word(const std::string& word);

}  // namespace isoloop
