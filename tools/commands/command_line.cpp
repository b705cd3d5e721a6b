#include "tools/commands/command_line.h"

#include <algorithm>
#include <exception>
#include <iostream>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "tools/commands/bench_command.h"
#include "tools/commands/convert_command.h"
#include "tools/commands/count_command.h"
#include "tools/commands/demo_command.h"
#include "tools/commands/generate_command.h"
#include "tools/commands/info_command.h"
#include "tools/commands/loops_command.h"
#include "tools/commands/overview_command.h"
#include "tools/commands/repair_command.h"
#include "tools/commands/scan_command.h"
#include "tools/commands/slicer_module.h"
#include "tools/commands/typed_words.h"
#include "tools/commands/view_command.h"
#include "tools/flags/input_flags.h"
#include "tools/runs/output_files.h"
#include "tools/words/exit_code.h"

namespace isoloop {
namespace {

std::vector<std::string> names_of(const CLI::App& app, bool hidden_ones) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({}))
    if (hidden_ones || !command->get_group().empty()) names.push_back(command->get_name());
  return names;
}

void describe(CLI::App& app) {
  app.name("isoloop");
  app.require_subcommand(1);
  app.set_help_all_flag("--help-all", "print this help with the flags that few need");
  app.set_version_flag("--version", "isoloop " ISOLOOP_VERSION "\nbuilt with " ISOLOOP_BUILT_WITH);
  app.add_flag_callback("--xml",
                        [] {
                          std::cout << slicer_descriptor();
                          throw CLI::Success();
                        })
      ->group("");
  app.footer(
      "Examples:\n"
      "  isoloop generate engine_block --size 128 -o block.vdb\n"
      "  isoloop loops block.vdb --ply loops.ply\n"
      "  isoloop count engine_256x256x128_uint8.raw --iso 70\n"
      "isoloop FILE says what a file holds, counts, and what to type next.\n"
      "isoloop COMMAND -h explains a command.\n"
      "Exit codes: 0 done, 2 usage, 3 unreadable input, 4 over a limit, 5 self-check failed.");
}

void add_commands(CLI::App& app, const std::vector<std::string>& typed) {
  add_info_command(app);
  add_count_command(app);
  add_loops_command(app);
  add_scan_command(app);
  add_view_command(app);
  add_repair_command(app);
  add_convert_command(app);
  add_generate_command(app);
  add_demo_command(app);
  add_bench_command(app);
  add_measure_command(app);
  add_overview_command(app, typed);
}

/// The typed words as CLI11 takes them, checked as far as their names go.
std::vector<std::string> checked_words(CLI::App& app, const std::vector<std::string>& typed) {
  const std::vector<std::string> names = names_of(app, true);
  std::vector<std::string> arguments = understood(typed, names);
  check_command(arguments, names, names_of(app, false));
  const auto has = [&](const char* word) {
    return std::find(arguments.begin(), arguments.end(), word) != arguments.end();
  };
  if (has("-h") || has("--help") || has("--help-all")) group_rare_flags(app, has("--help-all"));
  if (arguments[0].starts_with('-')) return arguments;
  if (arguments.back() == "--help-all") arguments.back() = "--help";
  check_flags_are_known(arguments, *app.get_subcommand(arguments[0]));
  return arguments;
}

void parse_and_run(const std::vector<std::string>& given) {
  const std::vector<std::string> typed = with_slicer_command(given);
  CLI::App app(
      "isoloop finds, proves and measures the handle loops and tunnel loops of an "
      "iso-surface in a volume.");
  describe(app);
  add_commands(app, typed);
  std::vector<std::string> reversed = tie_numbers_to_flags(checked_words(app, typed));
  std::reverse(reversed.begin(), reversed.end());  // as CLI11 wants them
  try {
    app.parse(reversed);
  } catch (const CLI::Success& request) {  // help or version
    app.exit(request, std::cout, std::cerr);
    finish_stdout();
  } catch (const CLI::ParseError& error) {
    const auto chosen = app.get_subcommands();
    const std::string help = chosen.empty() ? "isoloop" : "isoloop " + chosen[0]->get_name();
    throw InvalidArgument(std::string(error.what()) + " (see " + help + " -h)");
  }
}

}  // namespace

int run_command_line(const std::vector<std::string>& arguments) noexcept {
  try {
    parse_and_run(arguments);
    return static_cast<int>(ExitCode::done);
  } catch (...) {
    const std::string command = arguments.empty() ? "" : arguments[0];
    const Failure failure = failure_of(std::current_exception(), command);
    if (std::find(arguments.begin(), arguments.end(), "--log-json") != arguments.end()) {
      std::cerr << error_event(failure) << '\n';
    } else {
      std::cerr << "isoloop: " << failure.sentence << '\n';
    }
    return static_cast<int>(failure.code);
  }
}

}  // namespace isoloop
