#include "volume/mesh_text.h"

namespace isoloop {
namespace {

/// The line after "OFF", or the rest of that line, which may hold the counts.
void next_counts(LineReader& lines, bool& binary_or_other) {
  if (!lines.next('#')) throw lines.error("the file ends before its counts");
  const std::string_view word = lines.words()[0];
  binary_or_other = word != "OFF" && word != "COFF" && word != "NOFF";
}

}  // namespace

Mesh parse_off(std::string_view bytes, const std::string& what) {
  LineReader lines(bytes, what);
  bool other = false;
  next_counts(lines, other);
  if (other) throw lines.error("it does not begin with OFF, COFF or NOFF");
  const bool plain = lines.words()[0] == "OFF";
  std::size_t first = 1;  // word of the counts, where they follow in the same line
  if (lines.words().size() == 1) {
    if (!lines.next('#')) throw lines.error("the file ends before its counts");
    first = 0;
  }
  if (lines.words()[first] == "BINARY") throw lines.error("binary OFF is not read; export ASCII");
  if (lines.words().size() < first + 2) throw lines.error("the counts are missing");
  // A point takes six bytes or more ("0 0 0" and the end of the line), a face eight.
  const auto room = static_cast<std::int64_t>(lines.bytes_left());
  const auto points = lines.whole(lines.words()[first], 0, std::min(most_points, room / 6));
  const auto faces = lines.whole(lines.words()[first + 1], 0, room / 8);

  Mesh mesh;
  mesh.points.reserve(static_cast<std::size_t>(points));
  mesh.triangles.reserve(static_cast<std::size_t>(faces));
  for (std::int64_t p = 0; p < points; ++p) {
    if (!lines.next('#')) throw lines.error("the file ends within its points");
    const std::size_t words = lines.words().size();
    if (words < 3 || (plain && words > 3)) throw lines.error("a point has three coordinates");
    for (std::size_t w = 3; w < words; ++w) lines.number(w);
    mesh.points.push_back({lines.number(0), lines.number(1), lines.number(2)});
  }
  std::vector<std::uint32_t> polygon;
  for (std::int64_t f = 0; f < faces; ++f) {
    if (!lines.next('#')) throw lines.error("the file ends within its faces");
    const auto most_corners = static_cast<std::int64_t>(lines.words().size()) - 1;
    const std::int64_t corners = lines.whole(lines.words()[0], 3, most_corners);
    polygon.clear();
    for (std::int64_t c = 1; c <= corners; ++c) {
      const std::string_view word = lines.words()[static_cast<std::size_t>(c)];
      polygon.push_back(static_cast<std::uint32_t>(lines.whole(word, 0, points - 1)));
    }
    append_fan(mesh, polygon);  // numbers that follow are a colour
  }
  if (lines.next('#')) throw lines.error("more lines than the counts state");
  return mesh;
}

}  // namespace isoloop
