// What the readers of meshes share: lines, words, numbers and the sentences of their errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/errors.h"
#include "core/base/finding.h"
#include "volume/mesh/mesh.h"

namespace isoloop {

/// The lines of a text, each split into words. A line ends with "\n", "\r\n" or "\r"; a byte order
/// mark before the first is passed over.
class LineReader {
 public:
  LineReader(std::string_view text, std::string what);

  /// Goes to the next line that holds a word, and returns false if there is none. What follows
  /// `comment` in a line is no word; a line whose last letter is `goes_on` is one with the next. 0:
  /// there is no such letter.
  bool next(char comment = 0, char goes_on = 0);

  const std::vector<std::string_view>& words() const { return words_; }
  /// From the first word after the one of this number to the last; empty if there is none.
  std::string_view text_after(std::size_t word) const;
  std::size_t bytes_left() const { return text_.size(); }

  /// False if the last line that was looked at holds letters and no end: the file may be cut there.
  bool line_ends() const { return line_ends_; }

  /// The error that `why` is, at the present line.
  InvalidInput error(const std::string& why) const;

  /// Throws error() unless the word is a finite number.
  double number(std::size_t word) const;
  /// Throws error() unless the word is a whole number from `least` to `most`.
  std::int64_t whole(std::string_view word, std::int64_t least, std::int64_t most) const;

 private:
  std::string_view take_line();

  std::string_view text_;
  std::string what_;
  std::size_t line_ = 0;
  bool line_ends_ = true;
  std::vector<std::string_view> words_;
};

/// Whether `word` is `lower_case` but for capitals.
bool same_word(std::string_view word, std::string_view lower_case);

/// What a parser makes of a file.
struct ParsedMesh {
  Mesh mesh{};
  /// The file ends within the line of its last face, whose corners may have gone on: only a mesh
  /// that closes proves that they did not.
  bool last_face_may_be_cut = false;
};

/// Whether the last corner of the last triangle would still be one with a digit more.
bool last_corner_could_go_on(const Mesh& mesh);

/// What is said where the last line has no end and the file is read.
Finding unended_warning(const std::string& what);

/// What is said of faces that are left out because they hold no surface.
Finding small_faces_warning(std::size_t count, const std::string& what);

/// Appends the fan of a polygon.
void append_fan(Mesh& mesh, const std::vector<std::uint32_t>& polygon);

/// Most points of a mesh: corners are 32-bit.
constexpr std::int64_t most_points = 0xffffffff;

ParsedMesh parse_stl(std::string_view bytes, const std::string& what);
ParsedMesh parse_ply(std::string_view bytes, const std::string& what);
ParsedMesh parse_obj(std::string_view bytes, const std::string& what);
ParsedMesh parse_off(std::string_view bytes, const std::string& what);

}  // namespace isoloop
