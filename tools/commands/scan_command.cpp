#include "tools/commands/scan_command.h"

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "core/base/stage.h"
#include "core/base/threads.h"
#include "core/scan/scan.h"
#include "tools/flags/table_flags.h"
#include "tools/flags/thread_flag.h"
#include "tools/reports/report_scan.h"
#include "tools/reports/report_summary.h"
#include "tools/reports/scan_plot.h"
#include "tools/runs/output_files.h"
#include "tools/runs/read_run.h"
#include "tools/runs/report_run.h"
#include "tools/runs/scan_run.h"
#include "tools/words/flag_checks.h"
#include "tools/words/progress.h"

namespace isoloop {
namespace {

struct ScanFlags {
  VolumeFlags volume;
  LevelFlags level;
  ScanRange range;
  std::string ignored;  // "64", "0.1%" or empty
  int threads = 0;      // 0: one for each core
  ProgressFlags progress;
  std::string json;  // file, "-" or empty
  std::string csv;   // file, "-" or empty
  std::string svg;   // file, "-" or empty
  TableFlags table;
};

ScanRun scanned_run(const ScanFlags& flags, const Progress& progress) {
  LevelFlags level = flags.level;
  level.iso_is_open = true;
  ScanRun run{read_run(flags.volume, level)};
  const std::vector<double> isos = scan_values(flags.range, voxels_of(run), run.range);
  run.scan = in_stage(
      "scan", [&] { return scan_of(run, isos, progress, parse_ignored_size(flags.ignored)); });
  return run;
}

void scan(const ScanFlags& flags) {
  ScanRun run;
  parse_ignored_size(flags.ignored);  // refused before anything is read
  OutputFiles outputs(flags.volume.file);
  outputs.add("--json", flags.json, report_of(run, write_scan_json));
  outputs.add("--csv", flags.csv, report_of(run, write_scan_csv));
  outputs.add("--svg", flags.svg,
              [&run](std::ostream& out) { write_scan_svg(out, run.scan, run.level.inside); });
  if (!flags.volume.label.empty()) {
    throw InvalidArgument("scan looks for an iso value, and --label takes none; use count");
  }
  check_table_flags(flags.table, outputs.uses_stdout());
  run_and_report<ScanRun>(
      flags.progress, outputs, run,
      {.run = [&](const Progress& progress) { return scanned_run(flags, progress); },
       .table = flags.table.summary ? write_scan_summary : write_scan_table});
}

}  // namespace

void add_scan_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "scan", "count components, tunnels and cavities at all iso values, and propose one");
  auto flags = std::make_shared<ScanFlags>();
  add_convention_flags(command, flags->level);
  add_volume_flags(command, flags->volume);
  command.get_option("--label")->group("");  // understood, and refused with a word on what to do
  want_whole_number(
      command
          .add_option(
              "--values", flags->range.values,
              "how many iso values to look at (default 256, or all integers of a small range)")
          ->type_name("N"),
      1, max_scan_values);
  command
      .add_option("--from", flags->range.from, "the least of them (default: the least voxel value)")
      ->type_name("VALUE");
  command
      .add_option("--to", flags->range.to, "the largest of them (default: the largest voxel value)")
      ->type_name("VALUE");
  want_text(
      command
          .add_option("--ignore-below", flags->ignored,
                      "what is smaller does not break a plateau: components, tunnels and cavities, "
                      "in voxels or as a share of the largest component (default: 0, or of 64, 512 "
                      "and 4096 the first with which something is stable)")
          ->type_name("VOXELS|SHARE%"));
  const auto add_output = [&](const char* flag, std::string& name, const char* text) {
    want_file_name(command.add_option(flag, name, text)->type_name("FILE|-"));
  };
  add_output("--json", flags->json, "write the counts as JSON; - is standard output");
  add_output("--csv", flags->csv, "write one line for each iso value; - is standard output");
  add_output("--svg", flags->svg, "draw the counts as curves; - is standard output");
  add_summary_flag(command, flags->table);
  add_thread_flag(command, flags->threads);
  add_progress_flags(command, flags->progress);
  command.footer(
      "Examples:\n"
      "  isoloop scan engine_256x256x128_uint8.raw --svg curves.svg\n"
      "  isoloop scan block.vdb --values 100 --from -2 --to 2 --csv curves.csv\n"
      "  isoloop scan scan.raw --dims 512 512 300 --type i16 --from 0 --json -");
  command.callback([flags] { on_threads(flags->threads, [&] { scan(*flags); }); });
}

}  // namespace isoloop
