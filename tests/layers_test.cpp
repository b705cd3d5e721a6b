// The layout is the architecture: what includes what.
#include <filesystem>
#include <fstream>
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

}  // namespace
}  // namespace isoloop
