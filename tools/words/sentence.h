// The words of the command line: what was found, with the flags that it is about and what to do.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/finding.h"

namespace isoloop {

/// "--frame"; empty for an option without a flag.
std::string flag_of(Option option);

/// What to do, each of `advice` being enough, in the flags of `command` (count, repair, ...; empty:
/// those that all commands share). "raise --max-memory or read a part of the volume (--crop)".
std::string advice_text(const std::vector<Advice>& advice, std::string_view command = {});

/// "FILE: PLACE: TEXT; ADVICE" on one line without a full stop. The flag of `option`, where neither
/// the text nor the advice names one, is added in brackets.
std::string sentence_of(const Finding& finding, std::string_view command = {},
                        Option option = Option::none);

/// Without line ends and the full stop that other libraries put.
std::string one_line(std::string text);

/// One sentence each.
std::vector<std::string> sentences_of(const std::vector<Finding>& findings);

}  // namespace isoloop
