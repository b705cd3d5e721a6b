#include "tools/commands/bench_command.h"

#include <algorithm>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "core/base/threads.h"
#include "tools/bench/bench_flags.h"
#include "tools/bench/bench_plot.h"
#include "tools/bench/bench_run.h"
#include "tools/bench/report_bench.h"
#include "tools/runs/output_files.h"
#include "tools/runs/report_run.h"
#include "tools/words/exit_code.h"
#include "tools/words/flag_checks.h"
#include "tools/words/progress.h"

namespace isoloop {
namespace {

struct BenchCommand {
  BenchFlags bench;
  ProgressFlags progress;
  std::string json;  // file, "-" or empty
  std::string csv;   // file, "-" or empty
  std::string svg;   // file, "-" or empty
};

/// What fails is a row among others; where nothing was measured, it is how the command ends.
void check_any_measured(const BenchRun& run) {
  const auto is_measured = [](const BenchRow& row) { return row.failure.empty(); };
  if (std::any_of(run.rows.begin(), run.rows.end(), is_measured)) return;
  const BenchRow& row = run.rows.front();
  const std::string sentence = "nothing was measured: " + row.failure;
  switch (static_cast<ExitCode>(row.exit_code)) {
    case ExitCode::usage:
      throw InvalidArgument(sentence);
    case ExitCode::invalid_input:
      throw InvalidInput(sentence);
    case ExitCode::self_check_failed:
      throw SelfCheckFailed(sentence);
    default:
      throw LimitExceeded(sentence);
  }
}

void bench_and_report(const BenchCommand& flags, const CLI::App& command) {
  const BenchPlan plan = plan_of(flags.bench, command, static_cast<int>(thread_count()));
  BenchRun run;
  OutputFiles outputs(flags.bench.input.volume.file);
  outputs.add("--json", flags.json, report_of(run, write_bench_json));
  outputs.add("--csv", flags.csv, report_of(run, write_bench_csv));
  outputs.add("--svg", flags.svg, report_of(run, write_bench_svg));
  run_and_report<BenchRun>(
      flags.progress, outputs, run,
      {.run = [&](const Progress& progress) { return bench(plan, run_self, progress); },
       .settle = [](const BenchRun& measured) { check_any_measured(measured); },
       .table = write_bench_table});
}

}  // namespace

void add_bench_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "bench", "measure what finding loops takes: time, memory, growth, use of threads");
  auto flags = std::make_shared<BenchCommand>();
  add_bench_flags(command, flags->bench);
  const auto add_output = [&](const char* flag, std::string& name, const char* text) {
    want_file_name(command.add_option(flag, name, text)->type_name("FILE|-"));
  };
  add_output("--json", flags->json, "write all figures as JSON; - is standard output");
  add_output("--csv", flags->csv,
             "write one line for each stage of each case; - is standard output");
  add_output("--svg", flags->svg, "draw CPU time over voxels; - is standard output");
  add_progress_flags(command, flags->progress);
  command.footer(
      "Examples:\n"
      "  isoloop bench\n"
      "  isoloop bench --shapes lattice:7,trefoil --sizes 64,128 --threads 1,2,all --repeat 3\n"
      "  isoloop bench --file engine_256x256x128_uint8.raw --iso 70 --csv engine.csv");
  command.callback([flags, &command] { bench_and_report(*flags, command); });
}

}  // namespace isoloop
