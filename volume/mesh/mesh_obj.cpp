#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "volume/base/header_text.h"
#include "volume/mesh/mesh_text.h"

namespace isoloop {
namespace {

// Statements of the format that say nothing of a surface made of polygons.
constexpr std::array<std::string_view, 38> without_polygons{
    "vn",     "vt",     "vp",     "g",      "o",      "s",    "mg",         "mtllib",
    "usemtl", "l",      "p",      "usemap", "maplib", "lod",  "shadow_obj", "trace_obj",
    "bevel",  "cstype", "deg",    "bmat",   "step",   "curv", "curv2",      "parm",
    "trim",   "hole",   "scrv",   "sp",     "end",    "con",  "c_interp",   "d_interp",
    "ctech",  "stech",  "newmtl", "cdc",    "csh",    "res"};

// Those that add surfaces which are not read.
constexpr std::array<std::string_view, 5> other_surfaces{"surf", "bzp", "bsp", "cdp", "call"};

template <std::size_t Count>
bool contains(const std::array<std::string_view, Count>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

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

void add_point(const LineReader& lines, Mesh& mesh) {
  const std::size_t words = lines.words().size();
  // Further numbers are a weight or a colour.
  if (words < 4 || words > 8) throw lines.error("a point has three coordinates");
  for (std::size_t w = 1; w < words; ++w) lines.number(w);
  if (static_cast<std::int64_t>(mesh.points.size()) >= most_points) {
    throw lines.error("there are too many points");
  }
  mesh.points.push_back({lines.number(1), lines.number(2), lines.number(3)});
}

void add_face(const LineReader& lines, std::vector<std::uint32_t>& polygon, Mesh& mesh) {
  if (lines.words().size() < 4) throw lines.error("a face has three corners or more");
  polygon.clear();
  for (std::size_t w = 1; w < lines.words().size(); ++w) {
    polygon.push_back(corner(lines, lines.words()[w], mesh.points.size()));
  }
  append_fan(mesh, polygon);
}

/// Statements that the format does not have, by their first word, with their numbers.
class Strangers {
 public:
  void add(const LineReader& lines, const std::string& word) {
    constexpr std::size_t longest = 32;
    constexpr std::size_t most = 64;  // more of them are no extension of the format
    const bool is_name = word.size() <= longest && word[0] >= 'a' && word[0] <= 'z' &&
                         std::all_of(word.begin(), word.end(), [](char c) {
                           return c == '_' || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
                         });
    if (!is_name) throw lines.error("no OBJ statement begins so");
    ++counts_[word];
    if (counts_.size() > most) throw lines.error("it holds too many sorts of unknown statements");
  }

  void warn(const std::string& what, Mesh& mesh) const {
    if (counts_.empty()) return;
    std::string text;
    for (const auto& [word, count] : counts_) {
      text += (text.empty() ? "" : ", ") + word + " (" + std::to_string(count) + ")";
    }
    mesh.warnings.push_back(
        {.file = what, .text = "statements that OBJ does not have were skipped: " + text});
  }

 private:
  std::map<std::string, std::size_t> counts_;
};

}  // namespace

ParsedMesh parse_obj(std::string_view bytes, const std::string& what) {
  ParsedMesh parsed;
  Mesh& mesh = parsed.mesh;
  std::vector<std::uint32_t> polygon;
  Strangers strangers;
  LineReader lines(bytes, what);
  while (lines.next('#', '\\')) {
    const std::string word = lower_case(lines.words()[0]);
    if (word == "v") {
      if (!lines.line_ends()) throw lines.error("the file ends within a point");
      add_point(lines, mesh);
    } else if (word == "f" || word == "fo") {
      add_face(lines, polygon, mesh);
      parsed.last_face_may_be_cut = !lines.line_ends();
    } else if (contains(other_surfaces, word)) {
      throw lines.error(
          "free-form surfaces and surfaces of other files are not read; export "
          "triangles");
    } else if (!contains(without_polygons, word)) {
      strangers.add(lines, word);
    }
  }
  strangers.warn(what, mesh);
  if (!lines.line_ends()) mesh.warnings.push_back(unended_warning(what));
  mesh.loose_points = loose_points(mesh);
  return parsed;
}

}  // namespace isoloop
