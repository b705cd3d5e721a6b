// The layout is the architecture: what includes what.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

namespace fs = std::filesystem;

/// Everything that the sources of one folder include, with the file that does.
std::set<std::pair<std::string, std::string>> includes_of(const std::string& folder) {
  static const std::regex include(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
  std::set<std::pair<std::string, std::string>> found;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ISOLOOP_SOURCE) / folder)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);)
      if (std::smatch match; std::regex_search(line, match, include))
        found.emplace(match[1], entry.path().filename());
  }
  EXPECT_FALSE(found.empty());
  return found;
}

bool starts_with_any(const std::string& name, std::initializer_list<const char*> prefixes) {
  for (const char* prefix : prefixes)
    if (name.rfind(prefix, 0) == 0) return true;
  return false;
}

TEST(Layers, CoreSeesNoFilesAndNoOtherLayer) {
  for (const auto& [name, file] : includes_of("core"))
    EXPECT_FALSE(starts_with_any(name, {"volume/", "tools/", "tests/", "openvdb", "itk", "nlohmann",
                                        "CLI", "fstream", "filesystem", "cstdio", "iostream"}))
        << file << " includes " << name;
}

TEST(Layers, VolumeSeesNeitherToolsNorTheirLibraries) {
  for (const auto& [name, file] : includes_of("volume"))
    EXPECT_FALSE(starts_with_any(name, {"tools/", "tests/", "nlohmann", "CLI"}))
        << file << " includes " << name;
}

TEST(Layers, FewFilesSeeOpenVdb) {
  const std::set<std::string> allowed{"mesh_distance.cpp", "vdb_decode.cpp", "vdb_write.cpp"};
  for (const std::string folder : {"volume", "tools"})
    for (const auto& [name, file] : includes_of(folder))
      EXPECT_TRUE(allowed.count(file) > 0 || !starts_with_any(name, {"openvdb"})) << file;
}

TEST(Layers, OnlyTheCutOfCubesReadsItsTables) {
  // Everybody else asks sides, surface and grid_complex.
  for (const auto& [name, file] : includes_of("core"))
    EXPECT_TRUE(name != "core/cube.h" || starts_with_any(file, {"cube"}) || file == "sides.h")
        << file;
}

/// The number of each header's room in README's table.
std::map<std::string, int> rooms_of_core() {
  static const std::regex name("`([a-z0-9_]+)`");
  std::ifstream readme(fs::path(ISOLOOP_SOURCE) / "README.md");
  std::map<std::string, int> rooms;
  bool begun = false;
  int row = 0;
  for (std::string line; std::getline(readme, line); ++row) {
    begun = begun || line.rfind("The rooms of `core/`", 0) == 0;
    if (!begun || line.rfind("| `", 0) != 0) continue;
    const std::string headers = line.substr(0, line.find('|', 1));
    for (std::sregex_iterator i(headers.begin(), headers.end(), name), end; i != end; ++i)
      rooms.emplace((*i)[1], row);
  }
  return rooms;
}

TEST(Layers, RoomsOfCoreSeeThemselvesAndThoseBefore) {
  const std::map<std::string, int> rooms = rooms_of_core();
  for (const auto& [name, file] : includes_of("core")) {
    if (!starts_with_any(name, {"core/"})) continue;
    const auto from = rooms.find(fs::path(file).stem());
    const auto to = rooms.find(fs::path(name).stem());
    ASSERT_TRUE(from != rooms.end() && to != rooms.end()) << file << " or " << name;
    EXPECT_LE(to->second, from->second) << file << " includes " << name;
  }
}

}  // namespace
}  // namespace isoloop
