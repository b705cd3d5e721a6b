// README.md and docs/manual.md stay true: their commands print what they show, README's program is
// the one that is compiled, and the manual explains every flag and every field.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/samples/real_data.h"
#include "tests/samples/run_process.h"
#include "tests/samples/scratch_directory.h"
#include "volume/base/file_kind.h"

namespace isoloop {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string readme() { return text_of(fs::path(ISOLOOP_SOURCE) / "README.md"); }
std::string manual() { return text_of(fs::path(ISOLOOP_SOURCE) / "docs" / "manual.md"); }

Words split(const std::string& text, char separator) {
  Words parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// Contents of the fenced blocks of a language, README's first.
Words blocks_of(const std::string& language) {
  Words blocks;
  const std::string text = readme() + manual();
  const std::string fence = "\n```" + language + "\n";
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at + 1)) {
    const std::size_t begin = at + fence.size();
    blocks.push_back(text.substr(begin, text.find("\n```\n", begin) + 1 - begin));
  }
  return blocks;
}

/// A command and the lines shown below it.
struct Example {
  Words arguments;
  Words shown;
};

/// Those that run on `file`, in the order of the text.
std::vector<Example> examples_on(const std::string& file) {
  std::vector<Example> examples;
  bool wanted = false;
  for (const std::string& block : blocks_of("console")) {
    for (const std::string& line : split(block, '\n')) {
      if (line.starts_with("$ ")) {
        Words words = split(line.substr(2), ' ');
        wanted = words[0] == "isoloop" && std::count(words.begin(), words.end(), file) > 0;
        if (wanted) examples.push_back({{words.begin() + 1, words.end()}, {}});
      } else if (wanted) {
        examples.back().shown.push_back(line);
      }
    }
  }
  return examples;
}

/// What must not change: rows of loops and lengths may, where a shorter loop is found.
bool is_promised(const std::string& line) {
  static const std::regex may_change(
      R"( *[0-9]+  (handle|tunnel) .*|total length .*|id  kind .*|)");
  return line != "..." && !std::regex_match(line, may_change);
}

/// Runs all of them in one directory and looks for each promised line.
void expect_examples_to_hold(const std::string& file, const fs::path& directory) {
  const std::vector<Example> examples = examples_on(file);
  ASSERT_FALSE(examples.empty());
  for (const Example& example : examples) {
    const ProcessResult result = run_isoloop(directory, example.arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Words printed = split(result.out + result.err, '\n');
    for (const std::string& line : example.shown) {
      if (is_promised(line)) {
        EXPECT_NE(std::find(printed.begin(), printed.end(), line), printed.end())
            << "The text shows\n"
            << line << "\nbut " << example.arguments[0] << " prints\n"
            << result.out << result.err;
      }
    }
  }
}

TEST(Readme, CommandsOnTheBlockPrintWhatIsShown) {
  const ScratchDirectory scratch;
  expect_examples_to_hold("block.vdb", scratch.path());
}

TEST(Readme, CommandsOnTheEnginePrintWhatIsShown) {
  const std::string name = "engine_256x256x128_uint8.raw";
  ISOLOOP_NEEDS("volumes/" + name);
  const ScratchDirectory scratch;
  fs::create_symlink(fs::absolute(testing::data("volumes/" + name)), scratch.path() / name);
  expect_examples_to_hold(name, scratch.path());
}

TEST(Readme, ProgramIsTheExampleThatIsCompiled) {
  EXPECT_EQ(blocks_of("cpp"), Words{text_of(fs::path(ISOLOOP_SOURCE) / "examples" / "loops.cpp")});
}

std::set<std::string> flags_in(const std::string& text) {
  static const std::regex flag("--[a-z][a-z-]*");
  std::set<std::string> flags;
  for (std::sregex_iterator it(text.begin(), text.end(), flag), end; it != end; ++it)
    flags.insert(it->str());
  return flags;
}

TEST(Manual, ExplainsEveryFlagAndNoOther) {
  const ScratchDirectory scratch;
  std::string help;
  for (const char* command :
       {"info", "count", "scan", "loops", "view", "repair", "convert", "generate", "demo", "bench"})
    help += run_isoloop(scratch.path(), {command, "--help-all"}).out;
  help += run_isoloop(scratch.path(), {"-h"}).out;
  std::set<std::string> known = flags_in(help);
  const std::set<std::string> explained = flags_in(manual());
  for (const std::string& flag : known)
    EXPECT_EQ(explained.count(flag), 1U) << "the manual lacks " << flag;
  for (const std::string& flag : explained)
    EXPECT_EQ(known.count(flag), 1U) << "the manual explains " << flag;
  std::set<std::string> shown = flags_in(readme());
  for (const char* other : {"--rivals", "--build", "--install", "--preset", "--prefix"})
    shown.erase(other);  // of a script, and of cmake
  EXPECT_TRUE(std::includes(known.begin(), known.end(), shown.begin(), shown.end()));
}

TEST(Manual, AndTheHelpNameEveryExtensionOfTheTableOfFormats) {
  const ScratchDirectory scratch;
  const std::string text = manual();
  const std::string read_help = run_isoloop(scratch.path(), {"info", "-h"}).out;
  const std::string write_help = run_isoloop(scratch.path(), {"generate", "-h"}).out +
                                 run_isoloop(scratch.path(), {"loops", "-h"}).out;
  for (const FileFormat& format : file_formats()) {
    for (const std::string_view extension : format.extensions) {
      if (extension.empty()) continue;
      EXPECT_NE(text.find("`" + std::string(extension) + "`"), std::string::npos) << extension;
      EXPECT_NE(read_help.find(extension), std::string::npos) << extension;
    }
    if (format.written == Written::no) continue;
    EXPECT_NE(write_help.find(format.extensions[0]), std::string::npos) << format.name;
  }
}

void collect_keys(const Json& json, std::set<std::string>& keys) {
  for (const auto& [key, value] : json.items()) {
    if (json.is_object()) keys.insert(key);
    if (value.is_structured()) collect_keys(value, keys);
  }
}

TEST(Manual, ExplainsEveryFieldOfTheJsonAndEveryColumnOfTheTables) {
  const ScratchDirectory scratch;
  ASSERT_EQ(
      run_isoloop(scratch.path(), {"generate", "torus", "--size", "32", "-o", "t.vdb"}).exit_code,
      0);
  ASSERT_EQ(
      run_isoloop(scratch.path(), {"loops", "t.vdb", "--engine", "pair", "--features", "--json",
                                   "t.json", "--csv", "t.csv", "--dump-pairs", "pairs.csv"})
          .exit_code,
      0);
  ASSERT_EQ(run_isoloop(scratch.path(), {"bench", "--shapes", "torus,engine_block", "--sizes",
                                         "24,32", "--json", "b.json", "--csv", "b.csv"})
                .exit_code,
            0);
  std::set<std::string> fields;
  collect_keys(Json::parse(scratch.read("t.json")), fields);
  collect_keys(Json::parse(scratch.read("b.json")), fields);
  for (const char* table : {"t.csv", "pairs.csv", "b.csv"})
    for (const std::string& column : split(split(scratch.read(table), '\n')[0], ','))
      fields.insert(column);
  const std::string text = manual();
  for (const std::string& field : fields)
    EXPECT_NE(text.find("`" + field + "`"), std::string::npos) << field;
}

}  // namespace
}  // namespace isoloop
