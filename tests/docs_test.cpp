// The pages in docs/ name what is there.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

namespace fs = std::filesystem;

const fs::path root{ISOLOOP_SOURCE};

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// README, CONTRIBUTING and all of docs/.
std::vector<fs::path> pages() {
  std::vector<fs::path> found{root / "README.md", root / "CONTRIBUTING.md"};
  for (const auto& entry : fs::directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Docs, EveryFileThatAPageNamesIsThere) {
  // Capitals stand for a name to be filled in.
  static const std::regex named(
      R"re(`((?:core|volume|tools|tests|docs|include|examples)/[a-z0-9_/.]+\.(?:h|cpp|md|py|sh))`)re");
  std::size_t files = 0;
  for (const fs::path& page : pages()) {
    const std::string text = text_of(page);
    for (std::sregex_iterator it(text.begin(), text.end(), named), end; it != end; ++it, ++files)
      EXPECT_TRUE(fs::exists(root / (*it)[1].str())) << page << " names " << (*it)[1];
  }
  EXPECT_GT(files, 100U);
}

TEST(Docs, EveryLinkOfAPageLeadsToAFile) {
  static const std::regex link(R"re(\]\(([^)#:]+)(#[^)]*)?\))re");
  std::size_t links = 0;
  for (const fs::path& page : pages()) {
    const std::string text = text_of(page);
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it, ++links)
      EXPECT_TRUE(fs::exists(page.parent_path() / (*it)[1].str()))
          << page << " links to " << (*it)[1];
  }
  EXPECT_GT(links, 50U);
}

TEST(Docs, TheWordsOfEveryHeaderOfCoreAndOfTheFaceAreExplained) {
  const std::string words = text_of(root / "docs" / "words.md");
  for (const char* folder : {"core", "include"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      // What declares nothing has no words of its own.
      if (entry.path().extension() != ".h" ||
          text_of(entry.path()).find("\nnamespace isoloop {") == std::string::npos)
        continue;
      const std::string header = fs::relative(entry.path(), root).string();
      EXPECT_NE(words.find("`" + header + "`"), std::string::npos)
          << header << " is in no row of docs/words.md";
    }
}

}  // namespace
}  // namespace isoloop
