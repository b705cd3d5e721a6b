#include "volume/mesh_text.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "volume/header_text.h"

namespace isoloop {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";
constexpr std::size_t most_quoted = 40;  // characters of a garbled word in a message

std::string quoted(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, most_quoted)) text += c < ' ' || c > '~' ? '?' : c;
  return text + (word.size() > most_quoted ? "...'" : "'");
}

}  // namespace

LineReader::LineReader(std::string_view text, std::string what, std::size_t first_line)
    : text_(text), what_(std::move(what)), line_(first_line - 1) {
  if (!text_.empty() && text_.back() == '\n') return;
  throw InvalidInput(what_ + ": the last line does not end, so the file may be cut; fetch or " +
                     "export it again, or end the line if it is whole");
}

bool LineReader::next(char comment) {
  words_.clear();
  while (words_.empty() && !text_.empty()) {
    ++line_;
    const std::size_t end = text_.find('\n');
    std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end + 1);
    if (comment != 0) line = line.substr(0, line.find(comment));
    while (true) {
      const std::size_t start = line.find_first_not_of(blanks);
      if (start == std::string_view::npos) break;
      line.remove_prefix(start);
      words_.push_back(line.substr(0, line.find_first_of(blanks)));
      line.remove_prefix(words_.back().size());
    }
  }
  return !words_.empty();
}

InvalidInput LineReader::error(const std::string& why) const {
  return InvalidInput(what_ + ": line " + std::to_string(line_) + ": " + why +
                      "; fetch or export the file again");
}

double LineReader::number(std::size_t word) const {
  if (word >= words_.size()) throw error("a number is missing");
  std::string_view digits = words_[word];
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0.0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  // Too small for a double is as good as 0, which is what value still is.
  const bool tiny =
      problem == std::errc::result_out_of_range &&
      (digits.find("e-") != std::string_view::npos || digits.find("E-") != std::string_view::npos);
  const bool whole_word = end == digits.data() + digits.size() && !digits.empty();
  if (!whole_word || (problem != std::errc() && !tiny) || !std::isfinite(value)) {
    throw error(quoted(words_[word]) + " is no finite number");
  }
  return value;
}

std::int64_t LineReader::whole(std::string_view word, std::int64_t least, std::int64_t most) const {
  const std::optional<std::int64_t> value = whole_number_of(word);
  if (!value || *value < least || *value > most) {
    throw error(quoted(word) + " is no whole number from " + std::to_string(least) + " to " +
                std::to_string(most));
  }
  return *value;
}

void append_fan(Mesh& mesh, const std::vector<std::uint32_t>& polygon) {
  for (std::size_t c = 2; c < polygon.size(); ++c) {
    mesh.triangles.push_back({polygon[0], polygon[c - 1], polygon[c]});
  }
}

}  // namespace isoloop
