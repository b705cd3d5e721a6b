#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "volume/mesh/mesh_text.h"

namespace isoloop {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;

void append_triangle(Mesh& mesh) {
  const auto last = static_cast<std::uint32_t>(mesh.points.size());
  mesh.triangles.push_back({last - 3, last - 2, last - 1});
}

std::uint32_t little_uint32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t b = 4; b-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + b]);
  }
  return value;
}

float little_float(std::string_view bytes, std::size_t at) {
  const std::uint32_t bits = little_uint32(bytes, at);
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

Mesh parse_binary(std::string_view bytes, std::uint64_t triangles, const std::string& what) {
  if (triangles > std::numeric_limits<std::uint32_t>::max() / 3) {
    throw LimitExceeded(
        {.file = what,
         .text = std::to_string(triangles) + " triangles are more than isoloop can number"});
  }
  Mesh mesh;
  mesh.points.reserve(3 * triangles);
  mesh.triangles.reserve(triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    for (std::size_t c = 1; c <= 3; ++c) {  // 0 is the normal, which the corners say better
      const std::size_t at = header_bytes + triangle_bytes * t + 12 * c;
      Vec3 point{};
      for (std::size_t a = 0; a < 3; ++a) {
        point[a] = little_float(bytes, at + 4 * a);
        if (std::isfinite(point[a])) continue;
        throw InvalidInput({.file = what,
                            .place = "byte " + std::to_string(at + 4 * a),
                            .text = "a coordinate is not finite; fetch or export the file again"});
      }
      mesh.points.push_back(point);
    }
    append_triangle(mesh);
  }
  return mesh;
}

void expect(const LineReader& lines, std::size_t word, std::string_view text) {
  if (word < lines.words().size() && same_word(lines.words()[word], text)) return;
  throw lines.error("'" + std::string(text) + "' is missing");
}

void next_line(LineReader& lines) {
  if (!lines.next()) throw lines.error("the file ends within its triangles");
}

void parse_facet(LineReader& lines, Mesh& mesh) {
  expect(lines, 1, "normal");
  next_line(lines);
  expect(lines, 0, "outer");
  expect(lines, 1, "loop");
  for (int c = 0; c < 3; ++c) {
    next_line(lines);
    expect(lines, 0, "vertex");
    if (lines.words().size() != 4) throw lines.error("a point has three coordinates");
    mesh.points.push_back({lines.number(1), lines.number(2), lines.number(3)});
  }
  append_triangle(mesh);
  next_line(lines);
  expect(lines, 0, "endloop");
  next_line(lines);
  expect(lines, 0, "endfacet");
}

/// After the word endsolid nothing but a name can be missing from this solid.
void check_end(const LineReader& lines, std::string_view name, const std::string& what,
               Mesh& mesh) {
  if (lines.line_ends()) return;
  const std::string_view repeated = lines.text_after(0);
  if (!repeated.empty() && name.size() > repeated.size() && name.starts_with(repeated)) {
    throw lines.error("the file ends within the solid's name");
  }
  Finding warning = unended_warning(what);
  warning.text += ", without further solids";
  mesh.warnings.push_back(std::move(warning));
}

Mesh parse_ascii(std::string_view bytes, const std::string& what) {
  Mesh mesh;
  LineReader lines(bytes, what);
  while (lines.next()) {  // a file may hold several solids
    expect(lines, 0, "solid");
    const std::string_view name = lines.text_after(0);
    for (next_line(lines); same_word(lines.words()[0], "facet"); next_line(lines)) {
      if (static_cast<std::int64_t>(mesh.points.size()) + 3 > most_points) {
        throw lines.error("there are too many triangles");
      }
      parse_facet(lines, mesh);
    }
    expect(lines, 0, "endsolid");
    check_end(lines, name, what, mesh);
  }
  return mesh;
}

/// Some programs begin binary files with "solid" too, but they hold the byte 0: in the header, in
/// the count, or after the first triangle, where nearly all files have two of them.
bool is_ascii(std::string_view bytes) {
  if (bytes.substr(0, header_bytes + triangle_bytes).find('\0') != std::string_view::npos)
    return false;
  const std::size_t start = bytes.find_first_not_of(" \t\r\n\v\f\xef\xbb\xbf");
  return start != std::string_view::npos && same_word(bytes.substr(start, 5), "solid");
}

std::string stated_text(std::uint64_t stated, std::uint64_t present) {
  return "its header states " + std::to_string(stated) + " triangles, but " +
         std::to_string(present) + " follow: all are read; if the file was cut, nothing tells";
}

}  // namespace

ParsedMesh parse_stl(std::string_view bytes, const std::string& what) {
  const bool has_header = bytes.size() >= header_bytes;
  const std::uint64_t stated = has_header ? little_uint32(bytes, header_bytes - 4) : 0;
  const std::uint64_t present = has_header ? (bytes.size() - header_bytes) / triangle_bytes : 0;
  const bool whole = has_header && header_bytes + triangle_bytes * present == bytes.size();
  if (whole && stated == present) return {.mesh = parse_binary(bytes, present, what)};
  if (is_ascii(bytes)) return {.mesh = parse_ascii(bytes, what)};
  if (!has_header) {
    throw InvalidInput(
        {.file = what,
         .text = "the file has " + std::to_string(bytes.size()) +
                 " bytes, and an STL file begins with 'solid' or has 84 and more; fetch or " +
                 "export it again"});
  }
  // Programs that write as they go leave 0 or the largest number where the count should be.
  constexpr std::uint64_t unknown = std::numeric_limits<std::uint32_t>::max();
  if (whole && (stated < present || (stated == unknown && present > 0))) {
    Mesh mesh = parse_binary(bytes, present, what);
    mesh.warnings.push_back({.file = what, .text = stated_text(stated, present)});
    return {.mesh = std::move(mesh)};
  }
  throw InvalidInput({.file = what,
                      .text = "the file has " + std::to_string(bytes.size()) + " bytes, but the " +
                              std::to_string(stated) + " triangles that it states take " +
                              std::to_string(header_bytes + triangle_bytes * stated) +
                              "; fetch or export it again"});
}

}  // namespace isoloop
