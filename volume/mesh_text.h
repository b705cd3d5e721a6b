// What the readers of meshes share: lines, words, numbers and the sentences of their errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/errors.h"
#include "volume/mesh.h"

namespace isoloop {

/// The lines of a text, each split into words. Invariant: the text ends with the end of a line.
class LineReader {
 public:
  /// Text from `first_line` (numbered from 1) of the file on. Throws InvalidInput where the last
  /// line does not end.
  LineReader(std::string_view text, std::string what, std::size_t first_line = 1);

  /// Goes to the next line that holds a word, and returns false if there is none. What follows
  /// `comment` in a line is no word; 0: there are no comments.
  bool next(char comment = 0);

  const std::vector<std::string_view>& words() const { return words_; }
  std::size_t bytes_left() const { return text_.size(); }

  /// The error that `why` is, at the present line.
  InvalidInput error(const std::string& why) const;

  /// Throws error() unless the word is a finite number.
  double number(std::size_t word) const;
  /// Throws error() unless the word is a whole number from `least` to `most`.
  std::int64_t whole(std::string_view word, std::int64_t least, std::int64_t most) const;

 private:
  std::string_view text_;
  std::string what_;
  std::size_t line_;
  std::vector<std::string_view> words_;
};

/// Appends the fan of a polygon.
void append_fan(Mesh& mesh, const std::vector<std::uint32_t>& polygon);

/// Most points of a mesh: corners are 32-bit.
constexpr std::int64_t most_points = 0xffffffff;

Mesh parse_stl(std::string_view bytes, const std::string& what);
Mesh parse_ply(std::string_view bytes, const std::string& what);
Mesh parse_obj(std::string_view bytes, const std::string& what);
Mesh parse_off(std::string_view bytes, const std::string& what);

}  // namespace isoloop
