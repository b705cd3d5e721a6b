#include "tools/commands/count_command.h"

#include <memory>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "core/base/threads.h"
#include "tools/flags/table_flags.h"
#include "tools/flags/thread_flag.h"
#include "tools/reports/report_csv.h"
#include "tools/reports/report_json.h"
#include "tools/reports/report_summary.h"
#include "tools/reports/report_table.h"
#include "tools/runs/count_run.h"
#include "tools/runs/mesh_comparison.h"
#include "tools/runs/output_files.h"
#include "tools/runs/read_run.h"
#include "tools/runs/report_run.h"
#include "tools/words/flag_checks.h"
#include "tools/words/progress.h"

namespace isoloop {
namespace {

struct CountFlags {
  VolumeFlags volume;
  LevelFlags level;
  int threads = 0;  // 0: one for each core
  ProgressFlags progress;
  std::string json;  // file, "-" or empty
  std::string csv;   // file, "-" or empty
  TableFlags table;
};

void count(const CountFlags& flags) {
  CountRun run;
  OutputFiles outputs(flags.volume.file);
  outputs.add("--json", flags.json, report_of(run, write_count_json));
  outputs.add("--csv", flags.csv, report_of(run, write_count_csv));
  check_table_flags(flags.table, outputs.uses_stdout());
  run_and_report<CountRun>(
      flags.progress, outputs, run,
      {.run =
           [&](const Progress& progress) {
             return counted_run(read_run(flags.volume, flags.level), boundary_of(flags.level),
                                progress);
           },
       .settle = [](CountRun& counted) { compare_with_mesh(counted, counted.analysis); },
       .table = flags.table.summary ? write_count_summary : write_count_table});
}

}  // namespace

void add_count_command(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("count", "count components, tunnels and cavities, without loops");
  auto flags = std::make_shared<CountFlags>();
  add_level_flags(command, flags->level);
  add_volume_flags(command, flags->volume);
  want_file_name(
      command.add_option("--json", flags->json, "write the counts as JSON; - is standard output")
          ->type_name("FILE|-"));
  want_file_name(command
                     .add_option("--csv", flags->csv,
                                 "write one line for each component of the surface; - is standard "
                                 "output")
                     ->type_name("FILE|-"));
  add_summary_flag(command, flags->table);
  add_thread_flag(command, flags->threads);
  add_progress_flags(command, flags->progress);
  command.footer(
      "Examples:\n"
      "  isoloop count engine_256x256x128_uint8.raw --iso 70\n"
      "  isoloop count part.stl --resolution auto --json counts.json\n"
      "  isoloop count scan.raw --dims 512 512 300 --type i16 --iso 400 --json -");
  command.callback([flags] { on_threads(flags->threads, [&] { count(*flags); }); });
}

}  // namespace isoloop
