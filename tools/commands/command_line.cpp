#include "tools/commands/command_line.h"

#include <algorithm>
#include <exception>
#include <iostream>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "tools/commands/bench_command.h"
#include "tools/commands/count_command.h"
#include "tools/commands/generate_command.h"
#include "tools/commands/info_command.h"
#include "tools/commands/loops_command.h"
#include "tools/commands/measure_command.h"
#include "tools/commands/repair_command.h"
#include "tools/commands/scan_command.h"
#include "tools/commands/view_command.h"
#include "tools/flags/input_flags.h"
#include "tools/runs/output_files.h"
#include "tools/words/exit_code.h"

namespace isoloop {
namespace {

// CLI11 says of "isoloop lops" only that a subcommand is missing.
void check_command(const CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments[0].starts_with('-')) return;
  std::string names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == arguments[0]) return;
    if (command->get_group().empty()) continue;  // of isoloop's own
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  throw InvalidArgument(arguments[0] + " is no command; the commands are " + names +
                        " (see isoloop -h)");
}

void parse_and_run(const std::vector<std::string>& arguments) {
  CLI::App app(
      "isoloop finds, proves and measures the handle loops and tunnel loops of an "
      "iso-surface in a volume.");
  app.name("isoloop");
  app.require_subcommand(1);
  app.set_version_flag("--version", "isoloop " ISOLOOP_VERSION);
  app.footer(
      "Examples:\n"
      "  isoloop generate engine_block --size 128 -o block.vdb\n"
      "  isoloop loops block.vdb --ply loops.ply\n"
      "  isoloop count engine_256x256x128_uint8.raw --iso 70\n"
      "isoloop COMMAND -h explains a command.\n"
      "Exit codes: 0 done, 2 usage, 3 unreadable input, 4 over a limit, 5 self-check failed.");
  add_info_command(app);
  add_count_command(app);
  add_loops_command(app);
  add_scan_command(app);
  add_view_command(app);
  add_repair_command(app);
  add_generate_command(app);
  add_bench_command(app);
  add_measure_command(app);
  check_command(app, arguments);

  std::vector<std::string> reversed = tie_numbers_to_flags(arguments);
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
