#include "tools/commands/view_command.h"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "tools/flags/table_flags.h"
#include "tools/flags/thread_flag.h"
#include "tools/page/page.h"
#include "tools/reports/report_summary.h"
#include "tools/reports/report_table.h"
#include "tools/runs/loops_run.h"
#include "tools/runs/mesh_comparison.h"
#include "tools/runs/report_run.h"
#include "tools/words/flag_checks.h"
#include "tools/words/progress.h"

namespace isoloop {
namespace {

struct ViewFlags {
  LoopsInput input;
  ProgressFlags progress;
  std::string output;
  PageOptions page;
  TableFlags table;
};

/// FILE.html, beside a folder as well.
std::string default_page(std::string file) {
  while (file.size() > 1 && file.ends_with('/')) file.pop_back();
  if (file == "-") throw InvalidArgument("standard input has no name: give --output PAGE.html");
  return file + ".html";
}

void view_loops(const ViewFlags& typed) {
  ViewFlags flags = typed;
  if (flags.output.empty()) flags.output = default_page(flags.input.volume.file);
  LoopsRun run;
  OutputFiles outputs(flags.input.volume.file);
  LeftOut left_out;
  outputs.add("--output", flags.output,
              [&](std::ostream& out) { left_out = write_page(out, run, flags.page); });
  check_table_flags(flags.table, outputs.uses_stdout());
  run_and_report<LoopsRun>(
      flags.progress, outputs, run,
      {.run = [&](const Progress& progress) { return find_run(flags.input, progress); },
       .settle = [](LoopsRun& found) { compare_with_mesh(found, found.analysis); },
       .table =
           [&](std::ostream& out, const LoopsRun& found) {
             if (flags.table.summary) return write_loops_summary(out, found);
             write_table(out, found, most_rows(flags.table));
             out << "page: " << flags.output << left_out_text(left_out) << '\n';
           }});
}

}  // namespace

void add_view_command(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("view", "write the surface and its loops as a page for a web browser");
  auto flags = std::make_shared<ViewFlags>();
  flags->input.with_scan = true;
  flags->input.features = FeatureOptions{};
  flags->input.features_may_lack = true;
  add_level_flags(command, flags->input.level);
  add_volume_flags(command, flags->input.volume);
  want_file_name(command
                     .add_option("-o,--output", flags->output,
                                 "page to write, one file that needs no network (default: "
                                 "FILE.html); - is standard output")
                     ->type_name("FILE|-"));
  add_page_flags(command, flags->page);
  add_table_flags(command, flags->table);
  add_thread_flag(command, flags->input.threads);
  add_progress_flags(command, flags->progress);
  command.footer(
      "Examples:\n"
      "  isoloop view engine_256x256x128_uint8.raw --iso 70\n"
      "  isoloop view block.vdb --triangles 400000 -o page.html\n"
      "  isoloop view scan.raw --dims 512 512 300 --type i16 --iso 400 -o page.html");
  command.callback([flags] { view_loops(*flags); });
}

}  // namespace isoloop
