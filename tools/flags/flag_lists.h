// Lists of numbers and ranges as they are typed after flags.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/errors.h"
#include "volume/voxels/crop.h"

namespace isoloop {

/// The whole of `text` as a number; nothing if it is none.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (text.empty() || error != std::errc() || rest != end) return std::nullopt;
  return number;
}

/// Numbers parted by blanks, or by one of `marks`, after which there must be another. Throws
/// InvalidArgument with the complaint if there is none, or something else.
template <class Number>
std::vector<Number> parse_list(std::string_view text, std::string_view marks,
                               const std::string& complaint) {
  std::vector<Number> numbers;
  const auto pass_blanks = [&] {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  };
  for (bool is_wanted = true; is_wanted || !text.empty();) {
    pass_blanks();
    const std::string_view word = text.substr(0, text.find_first_of(std::string(marks) + " \t"));
    const std::optional<Number> number = parse_number<Number>(word);
    if (!number) throw InvalidArgument(complaint);
    numbers.push_back(*number);
    text.remove_prefix(word.size());
    pass_blanks();
    is_wanted = !text.empty() && marks.find(text.front()) != std::string_view::npos;
    if (is_wanted) text.remove_prefix(1);
  }
  return numbers;
}

/// Whole numbers from "3" or "3,7". Throws InvalidArgument.
std::vector<std::int64_t> parse_labels(std::string_view text);

/// Three ranges of voxels from "10:20,:,5:". Throws InvalidArgument.
CropBox parse_crop(std::string_view text);

}  // namespace isoloop
