// Rows of text in columns.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace isoloop {

template <std::size_t Columns>
using Row = std::array<std::string, Columns>;

/// Characters on screen: the bytes of UTF-8 that do not continue a character.
inline std::size_t screen_width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Two blanks between columns, numbers flush right; no blanks at the end of a line. Every row has
/// as many columns as `flush_left`.
inline void write_rows(std::ostream& out, const std::vector<std::vector<std::string>>& rows,
                       const std::vector<bool>& flush_left) {
  std::vector<std::size_t> width(flush_left.size());
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t c = 0; c < width.size(); ++c) {
      width[c] = std::max(width[c], screen_width(row[c]));
    }
  }
  for (const std::vector<std::string>& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < width.size(); ++c) {
      const std::string blanks(width[c] - screen_width(row[c]), ' ');
      if (c > 0) line += "  ";
      line += flush_left[c] ? row[c] + blanks : blanks + row[c];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  }
}

/// The same where the columns are known beforehand.
template <std::size_t Columns>
void write_rows(std::ostream& out, const std::vector<Row<Columns>>& rows,
                const std::array<bool, Columns>& flush_left) {
  std::vector<std::vector<std::string>> texts;
  texts.reserve(rows.size());
  for (const Row<Columns>& row : rows) texts.emplace_back(row.begin(), row.end());
  write_rows(out, texts, std::vector<bool>(flush_left.begin(), flush_left.end()));
}

}  // namespace isoloop
