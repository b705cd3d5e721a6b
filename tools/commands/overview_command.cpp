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
#include "tools/words/value_hints.h"

namespace isoloop {
namespace {

struct OverviewFlags {
  VolumeFlags volume;
  LevelFlags level;
  int threads = 0;
  ProgressFlags progress;
  std::string words;  // the file and the flags as a shell takes them, but for --iso auto
  std::string words_without_iso;
};

/// The words after the first command or file. Left out is `--iso auto`, or what --iso states too.
std::string words_to_repeat(const std::vector<std::string>& typed, bool with_iso) {
  std::string text;
  for (std::size_t i = 0; i < typed.size(); ++i) {
    if (i == 0 && typed[i] == overview_name) continue;
    const bool is_pair = typed[i] == "--iso";
    std::string words = shell_word(typed[i]);
    bool is_auto = typed[i] == "--iso=auto";
    if (is_pair && i + 1 < typed.size()) {
      is_auto = typed[i + 1] == "auto";
      do words += " " + shell_word(typed[++i]);
      while (i + 1 < typed.size() && parse_number<double>(typed[i + 1]));
    }
    if (is_auto || (!with_iso && (is_pair || typed[i].starts_with("--iso=")))) continue;
    text += " " + words;
  }
  return text;
}

bool states_iso(const OverviewFlags& flags) {
  return !flags.level.iso.empty() && flags.level.iso != "auto";
}

void write_next(std::ostream& out, const OverviewFlags& flags, const CountRun& counted) {
  const bool needs_iso =
      !counted.volume.level_set && !counted.volume.mask && flags.volume.label.empty();
  const std::string rest =
      flags.words +
      (needs_iso && !states_iso(flags) ? " --iso " + shortest_text(counted.level.iso) : "");
  out << "\nnext:  isoloop loops" << rest << "    finds and measures every handle and tunnel\n"
      << "       isoloop view" << rest << "    writes a page to look at\n"
      << (needs_iso
              ? "       isoloop scan" + flags.words_without_iso + "    counts at all iso values\n"
              : "")
      << "       isoloop -h    lists all commands\n";
}

/// What can be counted where no iso value could be chosen: a label.
void write_refusal(std::ostream& out, const OverviewFlags& flags, const CountRun& run,
                   const std::string& refusal) {
  out << "not counted: " << refusal << "\n\nnext:  ";
  const auto& labels = run.range.distinct;
  const auto label = std::find_if(labels.begin(), labels.end(), [](double x) { return x != 0.0; });
  if (is_label_map(run.range) && label != labels.end())
    out << "isoloop count" << flags.words << " --label " << shortest_text(*label)
        << "    counts one label\n       ";
  out << "isoloop -h    lists all commands\n";
}

/// Chooses an iso value where the flags and the file leave it open. Empty: done; else why not.
std::string choose_open_iso(const OverviewFlags& flags, RunInput& run) {
  const bool chooses = flags.level.iso == "auto";
  if (states_iso(flags) || (!chooses && (run.volume.mask || run.volume.level_set))) return "";
  try {
    const ChosenIso chosen = choose_iso(run);
    run.level.iso = chosen.iso;
    run.iso_choice = chosen.how;
    return "";
  } catch (const InvalidArgument& error) {
    return error.finding.text;
  }
}

CountRun overview_run(const OverviewFlags& flags, const Progress& progress, std::string& refusal) {
  LevelFlags level = flags.level;
  if (level.iso == "auto") level.iso.clear();
  level.iso_is_open = true;
  CountRun run{read_run(flags.volume, level)};
  refusal = choose_open_iso(flags, run);
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
             if (!refusal.empty()) return write_refusal(out, flags, counted, refusal);
             write_count_table(out, counted);
             write_next(out, flags, counted);
           }});
}

}  // namespace

void add_overview_command(CLI::App& app, const std::vector<std::string>& typed) {
  CLI::App& command = *app.add_subcommand(
      overview_name, "say what a file holds, count, and say what to type next: isoloop FILE");
  command.group("");  // not in the list of commands
  auto flags = std::make_shared<OverviewFlags>();
  flags->words = words_to_repeat(typed, true);
  flags->words_without_iso = words_to_repeat(typed, false);
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
