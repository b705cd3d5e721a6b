#include "tools/commands/overview_command.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "core/base/threads.h"
#include "tools/commands/info_command.h"
#include "tools/commands/typed_words.h"
#include "tools/flags/flag_lists.h"
#include "tools/flags/thread_flag.h"
#include "tools/reports/report_table.h"
#include "tools/runs/auto_iso.h"
#include "tools/runs/count_run.h"
#include "tools/runs/mesh_comparison.h"
#include "tools/runs/read_run.h"
#include "tools/runs/report_run.h"
#include "tools/words/number_text.h"
#include "tools/words/progress.h"

namespace isoloop {
namespace {

struct OverviewFlags {
  VolumeFlags volume;
  LevelFlags level;
  int threads = 0;
  ProgressFlags progress;
  std::string words;  // the file and all flags but --iso, as a shell takes them
};

/// The words after the first command or file, without --iso and what follows it.
std::string words_to_repeat(const std::vector<std::string>& typed) {
  std::string text;
  for (std::size_t i = 0; i < typed.size(); ++i) {
    if (i == 0 && typed[i] == overview_name) continue;
    if (typed[i].starts_with("--iso=")) continue;
    if (typed[i] == "--iso") {
      ++i;
      while (i + 1 < typed.size() && parse_number<double>(typed[i + 1])) ++i;
      continue;
    }
    text += " " + shell_word(typed[i]);
  }
  return text;
}

void write_next(std::ostream& out, const OverviewFlags& flags, const std::string& iso) {
  const std::string rest = flags.words + iso;
  out << "\nnext:  isoloop loops" << rest << "    finds and measures every handle and tunnel\n"
      << "       isoloop view" << rest << "    writes a page to look at\n"
      << (flags.volume.label.empty() && !iso.empty()
              ? "       isoloop scan" + flags.words + "    counts at all iso values\n"
              : "")
      << "       isoloop -h    lists all commands\n";
}

/// Settles what the solid is, where the flags leave that open. Empty: done; else why not.
std::string settle_level(const OverviewFlags& flags, RunInput& run) {
  const bool is_open = flags.level.iso.empty() && flags.volume.label.empty() && !run.volume.mask;
  if (!is_open && flags.level.iso != "auto") return "";
  try {
    const ChosenIso chosen = choose_iso(run);
    run.level.iso = chosen.iso;
    if (!run.volume.level_set) run.iso_choice = chosen.how;
    return "";
  } catch (const InvalidArgument& error) {
    return error.finding.text;
  }
}

CountRun overview_run(const OverviewFlags& flags, const Progress& progress, std::string& refusal) {
  LevelFlags level = flags.level;
  const bool stated = !level.iso.empty() && level.iso != "auto";
  if (!stated && flags.volume.label.empty()) level.iso = "0";  // stands in
  CountRun run{read_run(flags.volume, level)};
  refusal = settle_level(flags, run);
  if (!refusal.empty()) return run;
  return counted_run(std::move(run), boundary_of(flags.level), progress);
}

void overview(const OverviewFlags& flags) {
  CountRun run;
  std::string refusal;
  const OutputFiles none(flags.volume.file);
  run_and_report<CountRun>(
      flags.progress, none, run,
      {.run = [&](const Progress& progress) { return overview_run(flags, progress, refusal); },
       .settle =
           [&](CountRun& counted) {
             if (refusal.empty()) compare_with_mesh(counted, counted.analysis);
           },
       .table =
           [&](std::ostream& out, const CountRun& counted) {
             write_info(out, flags.volume, counted.volume);
             out << '\n';
             if (!refusal.empty()) {
               out << "not counted: " << refusal << '\n'
                   << "\nnext:  isoloop count" << flags.words << " --label 1    counts one label\n"
                   << "       isoloop -h    lists all commands\n";
               return;
             }
             write_count_table(out, counted);
             const bool by_itself =
                 counted.volume.level_set || counted.volume.mask || !flags.volume.label.empty();
             write_next(out, flags, by_itself ? "" : " --iso " + shortest_text(counted.level.iso));
           }});
}

}  // namespace

void add_overview_command(CLI::App& app, const std::vector<std::string>& typed) {
  CLI::App& command = *app.add_subcommand(
      overview_name, "say what a file holds, count, and say what to type next: isoloop FILE");
  command.group("");  // not in the list of commands
  auto flags = std::make_shared<OverviewFlags>();
  flags->words = words_to_repeat(typed);
  add_level_flags(command, flags->level);
  add_volume_flags(command, flags->volume);
  add_thread_flag(command, flags->threads);
  add_progress_flags(command, flags->progress);
  command.footer(
      "Examples:\n"
      "  isoloop engine_256x256x128_uint8.raw\n"
      "  isoloop scan.raw --dims 512 512 300 --type i16\n"
      "  isoloop part.stl");
  command.callback([flags] {
    try {
      on_threads(flags->threads, [&] { overview(*flags); });
    } catch (const InvalidArgument& error) {
      if (!write_series(std::cout, flags->volume, error, "isoloop" + flags->words)) throw;
      finish_stdout();
    }
  });
}

}  // namespace isoloop
