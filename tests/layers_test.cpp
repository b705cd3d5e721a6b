// The layout is the architecture: what includes what.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

namespace fs = std::filesystem;

/// Everything that the sources of one folder include, with the file that does, by its path.
std::set<std::pair<std::string, std::string>> includes_of(const std::string& folder) {
  static const std::regex include(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
  std::set<std::pair<std::string, std::string>> found;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ISOLOOP_SOURCE) / folder)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);)
      if (std::smatch match; std::regex_search(line, match, include))
        found.emplace(match[1], fs::relative(entry.path(), ISOLOOP_SOURCE).string());
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

TEST(Layers, ThePublicHeadersSeeTheStandardLibraryAndEachOther) {
  const std::regex standard("[a-z_]+");
  for (const auto& [name, file] : includes_of("include"))
    EXPECT_TRUE(std::regex_match(name, standard) || starts_with_any(name, {"isoloop/"}))
        << file << " includes " << name;
}

TEST(Layers, CoreSeesNoPublicHeaderOfVolumes) {
  for (const auto& [name, file] : includes_of("core"))
    EXPECT_FALSE(starts_with_any(
        name, {"isoloop/volume.h", "isoloop/read.h", "isoloop/shapes.h", "isoloop/isoloop.h"}))
        << file << " includes " << name;
}

TEST(Layers, OnlyTheLastRoomOfCoreSeesWhatItPromises) {
  for (const auto& [name, file] : includes_of("core"))
    EXPECT_TRUE(name != "isoloop/loops.h" || starts_with_any(file, {"core/library/"})) << file;
}

TEST(Layers, TheExamplesSeeThePublicHeadersAlone) {
  for (const auto& [name, file] : includes_of("examples"))
    EXPECT_FALSE(starts_with_any(name, {"core/", "volume/", "tools/", "tests/"}))
        << file << " includes " << name;
}

TEST(Layers, VolumeSeesNeitherToolsNorTheirLibraries) {
  for (const auto& [name, file] : includes_of("volume"))
    EXPECT_FALSE(starts_with_any(name, {"tools/", "tests/", "nlohmann", "CLI"}))
        << file << " includes " << name;
}

TEST(Layers, NoLayerSeesThePythonModule) {
  for (const std::string folder : {"include", "core", "volume", "tools"})
    for (const auto& [name, file] : includes_of(folder))
      EXPECT_FALSE(starts_with_any(name, {"python/", "pybind11", "Python.h"}))
          << file << " includes " << name;
}

TEST(Layers, ThePythonModuleSeesNoEngine) {
  for (const auto& [name, file] : includes_of("python"))
    EXPECT_FALSE(starts_with_any(name, {"core/"}) &&
                 !starts_with_any(name, {"core/base/errors.h", "core/base/threads.h"}))
        << file << " includes " << name;
}

TEST(Layers, FewFilesSeeOpenVdb) {
  const std::set<std::string> allowed{"volume/voxelize/mesh_distance.cpp",
                                      "volume/vdb/vdb_decode.cpp", "volume/vdb/vdb_write.cpp"};
  for (const std::string folder : {"volume", "tools"})
    for (const auto& [name, file] : includes_of(folder))
      EXPECT_TRUE(allowed.count(file) > 0 || !starts_with_any(name, {"openvdb"})) << file;
}

TEST(Layers, OnlyTheCutOfCubesReadsItsTables) {
  // Everybody else asks sides, surface and grid_complex.
  int readers = 0;
  for (const auto& [name, file] : includes_of("core")) {
    if (name != "core/cube/cube.h") continue;
    ++readers;
    EXPECT_TRUE(starts_with_any(file, {"core/cube/", "core/scan/cube_sweep.h"})) << file;
  }
  EXPECT_GT(readers, 1);
}

/// "core/grid" of "core/grid/level.h".
std::string folder_of(const std::string& file) { return fs::path(file).parent_path().string(); }

/// The folders that each folder's sources include from, itself not among them.
std::map<std::string, std::set<std::string>> arrows() {
  std::map<std::string, std::set<std::string>> to;
  for (const std::string layer : {"core", "volume", "tools"})
    for (const auto& [name, file] : includes_of(layer))
      if (starts_with_any(name, {"core/", "volume/", "tools/"}) &&
          folder_of(name) != folder_of(file))
        to[folder_of(file)].insert(folder_of(name));
  return to;
}

TEST(Layers, CoreAndVolumeNameNoFlag) {
  // What a flag is called is for tools/words/sentence.cpp to say; others have options.
  static const std::regex flag(R"re("[^"]*--[a-z][^"]*")re");
  for (const std::string layer : {"core", "volume"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(ISOLOOP_SOURCE) / layer)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);)
        EXPECT_FALSE(std::regex_search(line, flag)) << entry.path() << ": " << line;
    }
}

TEST(Layers, NoIncludeRunsBackBetweenFolders) {
  std::map<std::string, std::set<std::string>> left = arrows();
  // Takes away folders that see none of those left, until all are gone.
  for (bool found = true; found && !left.empty();) {
    found = false;
    for (auto folder = left.begin(); folder != left.end();) {
      const bool is_lowest = std::none_of(folder->second.begin(), folder->second.end(),
                                          [&](const auto& seen) { return left.count(seen) > 0; });
      folder = is_lowest ? left.erase(folder) : std::next(folder);
      found = found || is_lowest;
    }
  }
  for (const auto& [folder, seen] : left)
    for (const std::string& other : seen)
      EXPECT_EQ(left.count(other), 0U) << folder << " sees " << other << ", which sees it";
}

TEST(Layers, AFolderFitsAGlance) {
  std::map<std::string, int> headers;
  for (const std::string layer : {"include", "core", "volume", "tools", "python"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(ISOLOOP_SOURCE) / layer))
      if (entry.path().extension() == ".h") ++headers[entry.path().parent_path().string()];
  EXPECT_GT(headers.size(), 20U);
  for (const auto& [folder, count] : headers) EXPECT_LE(count, 14) << folder;
}

}  // namespace
}  // namespace isoloop
