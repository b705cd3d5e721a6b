#include "tools/commands/typed_words.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "tools/flags/flag_lists.h"
#include "tools/words/nearest_word.h"

namespace isoloop {
namespace {

using Words = std::vector<std::string>;

bool is_command(const std::string& word, const Words& commands) {
  return std::find(commands.begin(), commands.end(), word) != commands.end();
}

bool is_help(const std::string& word) {
  return word == "-h" || word == "--help" || word == "--help-all";
}

bool exists(const std::string& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

/// What other programs call a flag.
std::string usual_name(const std::string& typed) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 26> names{
      {{"-iso", "--iso"},
       {"-i", "--iso"},
       {"-t", "--iso"},
       {"--threshold", "--iso"},
       {"-threshold", "--iso"},
       {"--thresh", "--iso"},
       {"--isovalue", "--iso"},
       {"--iso-value", "--iso"},
       {"--level", "--iso"},
       {"--value", "--iso"},
       {"--shape", "--dims"},
       {"--dimensions", "--dims"},
       {"--dim", "--dims"},
       {"--dtype", "--type"},
       {"--datatype", "--type"},
       {"--voxel-size", "--spacing"},
       {"--voxelsize", "--spacing"},
       {"--pixel-size", "--spacing"},
       {"--roi", "--crop"},
       {"--out", "--output"},
       {"-j", "--threads"},
       {"--jobs", "--threads"},
       {"-q", "--quiet"},
       {"--memory", "--max-memory"},
       {"--fill", "--fill-tunnels"},
       {"--cut", "--cut-handles"}}};
  for (const auto& [usual, flag] : names)
    if (typed == usual) return std::string(flag);
  return "";
}

Words flags_of(const CLI::App& command) {
  Words flags;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  return flags;
}

/// The flag of the command that the word may mean; empty if none.
std::string meant_flag(const std::string& typed, const CLI::App& command) {
  const Words flags = flags_of(command);
  const std::string usual = usual_name(typed);
  if (std::find(flags.begin(), flags.end(), usual) != flags.end()) return usual;
  const std::size_t dashes = typed.find_first_not_of('-');
  return dashes == std::string::npos ? "" : nearest_word("--" + typed.substr(dashes), flags);
}

bool looks_like_a_flag(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && !parse_number<double>(word);
}

}  // namespace

Words understood(const Words& typed, const Words& commands) {
  if (typed.empty()) return {"--help"};
  const std::string& first = typed[0];
  if (first == "version" || first == "-v" || first == "-V") return {"--version"};
  if (first == "help") {
    if (typed.size() > 1 && is_command(typed[1], commands)) return {typed[1], "--help"};
    return {"--help"};
  }
  const auto end = std::find(typed.begin(), typed.end(), "--");
  const auto help = std::find_if(typed.begin(), end, is_help);
  if (is_command(first, commands)) return help == end ? typed : Words{first, *help};
  if (first != "-" && (looks_like_a_flag(first) || !exists(first))) return typed;
  Words words{overview_name};
  if (help != end) return {overview_name, *help};
  words.insert(words.end(), typed.begin(), typed.end());
  return words;
}

void check_command(const Words& typed, const Words& commands, const Words& shown) {
  const std::string& first = typed.front();
  if (looks_like_a_flag(first) || is_command(first, commands)) return;
  std::string names;
  for (const std::string& name : shown) names += (names.empty() ? "" : ", ") + name;
  const std::string nearest = nearest_word(first, shown);
  const bool is_path = first.find_first_of("./") != std::string::npos;
  throw InvalidArgument(first + (is_path ? " is no file and no command" : " is no command") +
                        (nearest.empty() ? "" : "; did you mean " + nearest + "?") +
                        "; the commands are " + names + " (see isoloop -h)");
}

void check_flags_are_known(const Words& typed, const CLI::App& command) {
  for (std::size_t i = 1; i < typed.size(); ++i) {
    const std::string& word = typed[i];
    if (word == "--") return;
    if (!looks_like_a_flag(word)) continue;
    const std::string name = word.substr(0, word.find('='));
    const CLI::Option* const option = command.get_option_no_throw(name);
    if (option != nullptr && option->get_name() != "FILE") {
      const bool takes_next = option->get_items_expected_max() > 0 && name == word;
      i += takes_next ? 1 : 0;
      continue;
    }
    // "-oFILE" is "-o FILE".
    if (word[1] != '-' && word.size() > 2 && command.get_option_no_throw(word.substr(0, 2)))
      continue;
    const std::string meant = meant_flag(name, command);
    throw InvalidArgument(name + " is no flag of isoloop " + command.get_name() +
                          (meant.empty() ? "" : "; did you mean " + meant + "?") +
                          " (see isoloop " + command.get_name() + " -h)");
  }
}

void group_rare_flags(CLI::App& app, bool all) {
  constexpr std::array<const char*, 22> rare{
      "--endian",     "--skip",          "--affine",    "--world",  "--nan-as",     "--max-voxels",
      "--max-memory", "--geodesic",      "--engine",    "--refine", "--dump-pairs", "--tighten",
      "--stats",      "--feature-ratio", "--triangles", "--grid",   "--series",     "--channel",
      "--frame",      "--open-boundary", "--complex",   "--grading"};
  for (CLI::App* command : app.get_subcommands({})) {
    bool has_rare = false;
    for (const char* flag : rare) {
      CLI::Option* const option = command->get_option_no_throw(flag);
      if (option == nullptr || option->get_group().empty()) continue;  // hidden: refused there
      option->group(all ? "Flags that few need" : "");
      has_rare = true;
    }
    if (has_rare && !all)
      command->footer(command->get_footer() + "\nisoloop " + command->get_name() +
                      " --help-all lists the flags that few need, too.");
  }
}

std::string shell_word(const std::string& word) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:,=+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace isoloop
