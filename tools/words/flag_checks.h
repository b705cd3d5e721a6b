// Checks of what is typed after a flag. Their sentences name the flag and what it wants.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "tools/words/cli_app.h"

namespace isoloop {

/// Refuses what is no whole number from `least` to `most`.
void want_whole_number(CLI::Option* option, std::int64_t least,
                       std::int64_t most = std::numeric_limits<std::int64_t>::max());

/// Refuses what is neither a whole number from `least` on nor `word`.
void want_whole_number_or(CLI::Option* option, std::int64_t least, const std::string& word);

/// Refuses what is no finite number above 0.
void want_positive_number(CLI::Option* option);

/// Refuses an empty text where the name of a file is wanted.
void want_file_name(CLI::Option* option);

/// Refuses an empty text.
void want_text(CLI::Option* option);

}  // namespace isoloop
