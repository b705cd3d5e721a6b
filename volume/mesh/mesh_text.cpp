#include "volume/mesh/mesh_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "volume/base/header_text.h"

namespace isoloop {
namespace {

constexpr std::string_view blanks = " \t\v\f";
constexpr std::size_t most_quoted = 40;  // characters of a garbled word in a message

std::string quoted(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, most_quoted)) text += c < ' ' || c > '~' ? '?' : c;
  return text + (word.size() > most_quoted ? "...'" : "'");
}

}  // namespace

LineReader::LineReader(std::string_view text, std::string what)
    : text_(text), what_(std::move(what)) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

bool LineReader::next(char comment, char goes_on) {
  words_.clear();
  bool joined = false;  // with the next line
  while ((words_.empty() || joined) && !text_.empty()) {
    ++line_;
    std::string_view line = take_line();
    if (comment != 0) line = line.substr(0, line.find(comment));
    while (true) {
      const std::size_t start = line.find_first_not_of(blanks);
      if (start == std::string_view::npos) break;
      line.remove_prefix(start);
      words_.push_back(line.substr(0, line.find_first_of(blanks)));
      line.remove_prefix(words_.back().size());
    }
    joined = goes_on != 0 && !words_.empty() && words_.back().ends_with(goes_on);
    if (!joined) continue;
    words_.back().remove_suffix(1);
    if (words_.back().empty()) words_.pop_back();
  }
  return !words_.empty();
}

std::string_view LineReader::take_line() {
  const std::size_t end = text_.find_first_of("\r\n");
  const std::string_view line = text_.substr(0, end);
  line_ends_ = end != std::string_view::npos || line.find_first_not_of(blanks) == end;
  const bool two_letters = text_.substr(std::min(end, text_.size())).starts_with("\r\n");
  text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + (two_letters ? 2 : 1));
  return line;
}

std::string_view LineReader::text_after(std::size_t word) const {
  if (word + 1 >= words_.size()) return {};
  const char* const first = words_[word + 1].data();
  return {first, static_cast<std::size_t>(words_.back().data() + words_.back().size() - first)};
}

InvalidInput LineReader::error(const std::string& why) const {
  return InvalidInput({.file = what_,
                       .place = "line " + std::to_string(line_),
                       .text = why + "; fetch or export the file again"});
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

bool same_word(std::string_view word, std::string_view lower_case) {
  return std::equal(word.begin(), word.end(), lower_case.begin(), lower_case.end(),
                    [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a + 32 == b); });
}

bool last_corner_could_go_on(const Mesh& mesh) {
  return !mesh.triangles.empty() &&
         std::uint64_t{10} * mesh.triangles.back()[2] < mesh.points.size();
}

Finding unended_warning(const std::string& what) {
  return {.file = what, .text = "the last line has no end; the file is taken to be whole"};
}

Finding small_faces_warning(std::size_t count, const std::string& what) {
  return {.file = what,
          .text = std::to_string(count) +
                  " faces of fewer than three corners hold no surface and were left out"};
}

void append_fan(Mesh& mesh, const std::vector<std::uint32_t>& polygon) {
  for (std::size_t c = 2; c < polygon.size(); ++c) {
    mesh.triangles.push_back({polygon[0], polygon[c - 1], polygon[c]});
  }
}

}  // namespace isoloop
