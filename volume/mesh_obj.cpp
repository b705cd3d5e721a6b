#include <algorithm>
#include <array>

#include "volume/mesh_text.h"

namespace isoloop {
namespace {

// Statements that say nothing of the surface.
constexpr std::array<std::string_view, 23> ignored{
    "vn",     "vt",     "vp",       "g",        "o",      "s",     "mg",         "mtllib",
    "usemtl", "l",      "p",        "usemap",   "maplib", "lod",   "shadow_obj", "trace_obj",
    "bevel",  "cstype", "c_interp", "d_interp", "ctech",  "stech", "newmtl"};

std::uint32_t corner(const LineReader& lines, std::string_view word, std::size_t points) {
  const std::string_view digits = word.substr(0, word.find('/'));
  const auto most = static_cast<std::int64_t>(points);
  const std::int64_t number = lines.whole(digits, -most, most);
  if (number == 0) throw lines.error("corners are counted from 1");
  return static_cast<std::uint32_t>(number > 0 ? number - 1 : most + number);
}

std::size_t loose_points(const Mesh& mesh) {
  std::vector<bool> used(mesh.points.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t point : triangle) used[point] = true;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

}  // namespace

Mesh parse_obj(std::string_view bytes, const std::string& what) {
  Mesh mesh;
  std::vector<std::uint32_t> polygon;
  LineReader lines(bytes, what);
  while (lines.next('#')) {
    const auto& words = lines.words();
    if (words.back() == "\\") throw lines.error("lines that go on in the next are not read");
    if (words[0] == "v") {
      // Further numbers are a weight or a colour.
      if (words.size() < 4 || words.size() > 8) throw lines.error("a point has three coordinates");
      for (std::size_t w = 1; w < words.size(); ++w) lines.number(w);
      if (static_cast<std::int64_t>(mesh.points.size()) >= most_points) {
        throw lines.error("there are too many points");
      }
      mesh.points.push_back({lines.number(1), lines.number(2), lines.number(3)});
    } else if (words[0] == "f" || words[0] == "fo") {
      if (words.size() < 4) throw lines.error("a face has three corners or more");
      polygon.clear();
      for (std::size_t w = 1; w < words.size(); ++w) {
        polygon.push_back(corner(lines, words[w], mesh.points.size()));
      }
      append_fan(mesh, polygon);
    } else if (words[0] == "curv" || words[0] == "surf" || words[0] == "curv2") {
      throw lines.error("curves and free-form surfaces are not read; export triangles");
    } else if (std::find(ignored.begin(), ignored.end(), words[0]) == ignored.end()) {
      throw lines.error("no OBJ statement begins so");
    }
  }
  mesh.loose_points = loose_points(mesh);
  return mesh;
}

}  // namespace isoloop
