#include "volume/base/header_text.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <span>
#include <system_error>

#include "core/base/errors.h"

namespace isoloop {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

template <class Number>
std::optional<Number> parsed(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number number{};
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, number);
  if (word.empty() || error != std::errc() || rest != end) return std::nullopt;
  return number;
}

template <class Number>
std::vector<Number> all_parsed(std::string_view text, std::size_t count, const std::string& what) {
  std::vector<Number> numbers;
  bool good = true;
  for (const std::string& word : words_of(text)) {
    const std::optional<Number> number = parsed<Number>(word);
    good = good && number;
    numbers.push_back(number.value_or(Number{}));
  }
  if (good && (count == 0 || numbers.size() == count)) return numbers;
  const std::string wanted = count == 0 ? "numbers" : std::to_string(count) + " numbers";
  throw InvalidInput({.file = what,
                      .text = "'" + std::string(text.substr(0, 80)) + "' where " + wanted +
                              " should be; correct the header"});
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  while (true) {
    const std::size_t start = text.find_first_not_of(blanks);
    if (start == std::string_view::npos) return words;
    text.remove_prefix(start);
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    words.emplace_back(word);
    text.remove_prefix(word.size());
  }
}

std::optional<double> number_of(std::string_view word) { return parsed<double>(word); }

std::optional<std::int64_t> whole_number_of(std::string_view word) {
  return parsed<std::int64_t>(word);
}

std::vector<double> numbers_of(std::string_view text, std::size_t count, const std::string& what) {
  return all_parsed<double>(text, count, what);
}

std::vector<std::int64_t> whole_numbers_of(std::string_view text, std::size_t count,
                                           const std::string& what) {
  return all_parsed<std::int64_t>(text, count, what);
}

std::string read_line_or_rest(ByteStream& stream, const std::string& what, bool& is_ended) {
  constexpr std::size_t longest = std::size_t{1} << 16;
  std::string line;
  while (line.size() < longest) {
    is_ended = line.empty() || stream.most_left() > 0;
    if (!is_ended) return line;
    std::byte next{};
    stream.read(std::span(&next, 1), "its header");
    if (next == std::byte{'\n'}) {
      if (line.ends_with('\r')) line.pop_back();
      return line;
    }
    line.push_back(static_cast<char>(next));
  }
  throw InvalidInput(
      {.file = what, .text = "a line of its header is longer than 64 KiB; is it such a file?"});
}

std::string read_line(ByteStream& stream, const std::string& what) {
  bool is_ended = true;
  std::string line = read_line_or_rest(stream, what, is_ended);
  if (!is_ended)
    throw InvalidInput({.file = what, .text = "ends within its header; fetch the file again"});
  return line;
}

Finding unended_header_warning(const std::string& what) {
  return {.file = what, .text = "the last line of the header has no end; it is taken to be whole"};
}

bool names_several_files(const std::filesystem::path& header, std::string_view name) {
  if (name.empty()) return true;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(beside(header, name), ignored)) return false;
  if (lower_case(words_of(name).front()) == "list") return true;
  for (std::size_t at = name.find('%'); at != std::string_view::npos; at = name.find('%', at + 1)) {
    const std::size_t end = name.find_first_not_of("0123456789", at + 1);
    if (end != std::string_view::npos && (name[end] == 'd' || name[end] == 'i' || name[end] == 'u'))
      return true;
  }
  return false;
}

std::filesystem::path beside(const std::filesystem::path& header, std::string_view name) {
  return header.parent_path() / std::filesystem::path(name);
}

}  // namespace isoloop
