#include <algorithm>
#include <optional>
#include <utility>

#include "volume/base/header_text.h"
#include "volume/mesh/mesh_text.h"

namespace isoloop {
namespace {

struct Counts {
  std::int64_t points = 0;
  std::int64_t faces = 0;
  bool coordinates_alone = true;  // a point has no normal, colour or texture coordinates
};

/// Whether points of this header word, such as OFF or STCNOFF, hold coordinates alone.
bool coordinates_alone(const LineReader& lines) {
  std::string word(lines.words()[0]);
  if (lower_case(word) == word) {
    for (char& c : word) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  std::string_view rest = word;
  for (std::size_t size = 0; size != rest.size();) {
    size = rest.size();
    for (const std::string_view prefix : {"ST", "C", "N"}) {
      if (rest.starts_with(prefix)) rest.remove_prefix(prefix.size());
    }
  }
  if (rest == "OFF") return rest.size() == word.size();
  if (rest == "4OFF" || rest == "nOFF" || rest == "4nOFF") {
    throw lines.error("points of more than three dimensions are not read; export OFF");
  }
  throw lines.error("it does not begin with OFF, COFF, NOFF or their like");
}

/// In the line after the header word or in the rest of its own; some files have no such word.
Counts read_counts(LineReader& lines) {
  if (!lines.next('#')) throw lines.error("the file ends before its counts");
  Counts counts;
  const bool has_word = !whole_number_of(lines.words()[0]);
  if (has_word) counts.coordinates_alone = coordinates_alone(lines);
  std::size_t first = has_word ? 1 : 0;  // word of the counts
  if (has_word && lines.words().size() == 1) {
    if (!lines.next('#')) throw lines.error("the file ends before its counts");
    first = 0;
  }
  if (lines.words()[first] == "BINARY") throw lines.error("binary OFF is not read; export ASCII");
  if (lines.words().size() < first + 2) throw lines.error("the counts are missing");
  // A point takes six bytes or more ("0 0 0" and the end of the line, which the last line may do
  // without), a face two.
  const auto room = static_cast<std::int64_t>(lines.bytes_left()) + 1;
  counts.points = lines.whole(lines.words()[first], 0, std::min(most_points, room / 6));
  counts.faces = lines.whole(lines.words()[first + 1], 0, room / 2);
  return counts;
}

/// Returns whether a point holds more numbers than its header says.
bool read_points(LineReader& lines, const Counts& counts, Mesh& mesh) {
  mesh.points.reserve(static_cast<std::size_t>(counts.points));
  bool has_more = false;
  for (std::int64_t p = 0; p < counts.points; ++p) {
    if (!lines.next('#')) throw lines.error("the file ends within its points");
    const std::size_t words = lines.words().size();
    if (words < 3) throw lines.error("a point has three coordinates");
    for (std::size_t w = 3; w < words; ++w) lines.number(w);
    has_more = has_more || (counts.coordinates_alone && words > 3);
    mesh.points.push_back({lines.number(0), lines.number(1), lines.number(2)});
  }
  return has_more;
}

}  // namespace

ParsedMesh parse_off(std::string_view bytes, const std::string& what) {
  ParsedMesh parsed;
  Mesh& mesh = parsed.mesh;
  LineReader lines(bytes, what);
  const Counts counts = read_counts(lines);
  if (read_points(lines, counts, mesh)) {
    mesh.warnings.push_back({.file = what,
                             .text = "points hold more than three numbers, although the header is "
                                     "OFF: the first three are taken to be the coordinates"});
  }
  std::vector<std::uint32_t> polygon;
  std::size_t too_small = 0;
  for (std::int64_t f = 0; f < counts.faces; ++f) {
    if (!lines.next('#')) throw lines.error("the file ends within its faces");
    const auto most_corners = static_cast<std::int64_t>(lines.words().size()) - 1;
    const std::int64_t corners = lines.whole(lines.words()[0], 0, most_corners);
    polygon.clear();
    for (std::int64_t c = 1; c <= corners; ++c) {
      const std::string_view word = lines.words()[static_cast<std::size_t>(c)];
      polygon.push_back(static_cast<std::uint32_t>(lines.whole(word, 0, counts.points - 1)));
    }
    too_small += corners < 3 ? 1 : 0;
    append_fan(mesh, polygon);  // numbers that follow are a colour
    parsed.last_face_may_be_cut = !lines.line_ends() && corners == most_corners && corners >= 3 &&
                                  last_corner_could_go_on(mesh);
  }
  if (too_small > 0) mesh.warnings.push_back(small_faces_warning(too_small, what));
  if (lines.next('#')) throw lines.error("more lines than the counts state");
  if (!lines.line_ends()) mesh.warnings.push_back(unended_warning(what));
  return parsed;
}

}  // namespace isoloop
