#include "tools/flags/length_flag.h"

#include <cmath>
#include <optional>

#include "core/base/errors.h"
#include "tools/flags/flag_lists.h"
#include "tools/words/number_text.h"

namespace isoloop {
namespace {

/// Where the number at the begin of the word ends.
std::size_t number_end(std::string_view word) {
  constexpr std::string_view parts = "0123456789.+-";
  std::size_t end = 0;
  while (end < word.size() && (parts.find(word[end]) != std::string_view::npos ||
                               ((word[end] == 'e' || word[end] == 'E') && end + 1 < word.size() &&
                                parts.find(word[end + 1]) != std::string_view::npos)))
    ++end;
  return end;
}

}  // namespace

TypedLength parse_length(const std::string& flag, std::string_view text) {
  if (const auto number = parse_number<double>(text); number && !std::isnan(*number))
    return {*number, ""};
  const UnitOfText split = split_unit(flag, text);
  const auto number = parse_number<double>(split.text);
  if (!number || std::isnan(*number))
    throw InvalidArgument(flag + " " + std::string(text) + " is no length, as 20 and 20mm are");
  return {*number, split.unit};
}

bool is_length(std::string_view word) {
  const std::size_t end = number_end(word);
  return parse_number<double>(word.substr(0, end)) &&
         (end == word.size() || length_unit(word.substr(end)));
}

double length_in(const TypedLength& length, const Volume& volume, const std::string& flag) {
  if (length.unit.empty()) return length.value;
  const std::optional<LengthUnit> typed = length_unit(length.unit);
  const std::optional<LengthUnit> stated = length_unit(volume.unit);
  if (!typed || !stated)
    throw InvalidArgument(flag + " " + shortest_text(length.value) + length.unit +
                          ": the file states no unit of its spacing; leave the unit out, or state "
                          "it with --spacing, as in --spacing 0.5" +
                          length.unit);
  return length.value * (typed->metres / stated->metres);
}

UnitOfText split_unit(const std::string& flag, std::string_view text) {
  UnitOfText split;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t blank = std::min(text.find_first_of(" \t,xX", at), text.size());
    const std::string_view word = text.substr(at, blank - at);
    const std::size_t end = number_end(word);
    split.text += word.substr(0, end);
    if (end < word.size()) {
      const std::optional<LengthUnit> unit = length_unit(word.substr(end));
      if (!unit || (!split.unit.empty() && split.unit != unit->name))
        throw InvalidArgument(flag + " " + std::string(text) + ": '" +
                              std::string(word.substr(end)) +
                              (unit ? "' is another unit" : "' is no unit of length, as mm is"));
      split.unit = unit->name;
    }
    if (blank < text.size()) split.text += text[blank];
    at = blank + 1;
  }
  return split;
}

}  // namespace isoloop
