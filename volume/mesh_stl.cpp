#include <cmath>
#include <cstring>
#include <limits>

#include "volume/mesh_text.h"

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

Mesh parse_binary(std::string_view bytes, const std::string& what) {
  const std::uint32_t triangles = little_uint32(bytes, header_bytes - 4);
  if (triangles > std::numeric_limits<std::uint32_t>::max() / 3) {
    throw LimitExceeded(what + ": " + std::to_string(triangles) +
                        " triangles are more than isoloop can number");
  }
  Mesh mesh;
  mesh.points.reserve(std::size_t{3} * triangles);
  mesh.triangles.reserve(triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    for (std::size_t c = 1; c <= 3; ++c) {  // 0 is the normal, which the corners say better
      const std::size_t at = header_bytes + triangle_bytes * t + 12 * c;
      Vec3 point{};
      for (std::size_t a = 0; a < 3; ++a) {
        point[a] = little_float(bytes, at + 4 * a);
        if (std::isfinite(point[a])) continue;
        throw InvalidInput(what + ": byte " + std::to_string(at + 4 * a) +
                           ": a coordinate is not finite; fetch or export the file again");
      }
      mesh.points.push_back(point);
    }
    append_triangle(mesh);
  }
  return mesh;
}

void expect(const LineReader& lines, std::size_t word, std::string_view text) {
  if (word < lines.words().size() && lines.words()[word] == text) return;
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

Mesh parse_ascii(std::string_view bytes, const std::string& what) {
  Mesh mesh;
  LineReader lines(bytes, what);
  while (lines.next()) {  // a file may hold several solids
    expect(lines, 0, "solid");
    for (next_line(lines); lines.words()[0] == "facet"; next_line(lines)) {
      if (static_cast<std::int64_t>(mesh.points.size()) + 3 > most_points) {
        throw lines.error("there are too many triangles");
      }
      parse_facet(lines, mesh);
    }
    expect(lines, 0, "endsolid");
  }
  return mesh;
}

}  // namespace

Mesh parse_stl(std::string_view bytes, const std::string& what) {
  const bool has_header = bytes.size() >= header_bytes;
  const std::uint64_t stated = has_header ? little_uint32(bytes, header_bytes - 4) : 0;
  const std::uint64_t expected = header_bytes + triangle_bytes * stated;
  // Some programs begin binary files with "solid" too; the size tells.
  if (has_header && bytes.size() == expected) return parse_binary(bytes, what);
  if (bytes.starts_with("solid")) return parse_ascii(bytes, what);
  if (!has_header) {
    throw InvalidInput(what + ": the file has " + std::to_string(bytes.size()) +
                       " bytes, and an STL file begins with 'solid' or has 84 and more; fetch or " +
                       "export it again");
  }
  throw InvalidInput(what + ": the file has " + std::to_string(bytes.size()) + " bytes, but the " +
                     std::to_string(stated) + " triangles that it states take " +
                     std::to_string(expected) + "; fetch or export it again");
}

}  // namespace isoloop
