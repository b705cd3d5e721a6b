#include "tools/words/flag_checks.h"

#include <cmath>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "volume/base/header_text.h"

namespace isoloop {
namespace {

constexpr std::size_t longest_shown = 40;  // letters of what was typed

std::string wanted(const std::string& what, const std::string& typed) {
  return what + " is wanted, not '" + typed.substr(0, longest_shown) +
         (typed.size() > longest_shown ? "...'" : "'");
}

}  // namespace

void want_whole_number(CLI::Option* option, std::int64_t least, std::int64_t most) {
  const bool open_ended = most == std::numeric_limits<std::int64_t>::max();
  const std::string what = "a whole number from " + std::to_string(least) +
                           (open_ended ? " on" : " to " + std::to_string(most));
  option->check([=](const std::string& typed) {
    const std::optional<std::int64_t> number = whole_number_of(typed);
    return number && *number >= least && *number <= most ? "" : wanted(what, typed);
  });
}

void want_whole_number_or(CLI::Option* option, std::int64_t least, const std::string& word) {
  option->check([=](const std::string& typed) {
    const std::optional<std::int64_t> number = whole_number_of(typed);
    return typed == word || (number && *number >= least)
               ? ""
               : wanted("a whole number from " + std::to_string(least) + " on, or " + word + ",",
                        typed);
  });
}

void want_positive_number(CLI::Option* option) {
  option->check([](const std::string& typed) {
    const std::optional<double> number = number_of(typed);
    const bool good = number && *number > 0.0 && std::isfinite(*number);
    return good ? "" : wanted("a number above 0", typed);
  });
}

void want_file_name(CLI::Option* option) {
  option->check([](const std::string& typed) {
    return typed.empty() ? std::string("the name of a file is wanted") : "";
  });
}

void want_text(CLI::Option* option) {
  option->check([](const std::string& typed) {
    return typed.empty() ? std::string("something is wanted after it") : "";
  });
}

}  // namespace isoloop
