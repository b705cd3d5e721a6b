#include "tools/commands/demo_command.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "tools/page/page.h"
#include "tools/reports/report_table.h"
#include "tools/runs/loops_run.h"
#include "tools/runs/report_run.h"
#include "tools/words/flag_checks.h"
#include "tools/words/progress.h"
#include "volume/files/write.h"
#include "volume/shapes/shapes.h"

namespace isoloop {
namespace {

struct DemoFlags {
  std::string folder = "isoloop-demo";
  ProgressFlags progress;
};

std::filesystem::path made_folder(const std::string& name) {
  std::error_code error;
  std::filesystem::create_directories(name, error);
  if (error)
    throw InvalidInput({.file = name, .text = "cannot be made: " + error.message()},
                       Fault::unwritable);
  return name;
}

/// The block by file, so that what is shown is what the command for it shows too.
KnownTopology write_block(const std::string& file) {
  Shape block = make_shape("engine_block");
  clip_to_narrow_band(block);
  write_volume(block.volume, file);
  if (!block.known) throw SelfCheckFailed("the topology of the engine block is known");
  return *block.known;
}

void check_known(const Betti& found, const KnownTopology& known) {
  if (found.b0 != known.b0 || found.b1 != known.b1 || found.b2 != known.b2)
    throw SelfCheckFailed("the counts of the engine block are not those known by construction");
}

void show(const DemoFlags& flags) {
  const std::filesystem::path folder = made_folder(flags.folder);
  const std::string block = (folder / "engine_block.vdb").string();
  const std::string page = (folder / "engine_block.html").string();
  const KnownTopology known = write_block(block);
  LoopsInput input;
  input.volume.file = block;
  input.with_scan = true;
  input.features = FeatureOptions{};
  LoopsRun run;
  OutputFiles outputs(block);
  outputs.add("--output", page, report_of(run, [](std::ostream& out, const LoopsRun& found) {
                write_page(out, found);
              }));
  run_and_report<LoopsRun>(
      flags.progress, outputs, run,
      {.run = [&](const Progress& progress) { return find_run(input, progress); },
       .settle = [&](LoopsRun& found) { check_known(found.analysis.betti, known); },
       .table = [](std::ostream& out, const LoopsRun& found) { write_table(out, found); }});
  std::cout
      << "\nThe counts are those known by construction. To see the loops, open in a browser:\n"
      << "  " << std::filesystem::absolute(page).string()
      << "\nThe same, step by step:\n  isoloop generate engine_block -o block.vdb\n"
         "  isoloop count block.vdb\n  isoloop view block.vdb -o block.html\n";
  finish_stdout();
}

}  // namespace

void add_demo_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "demo", "make the built-in engine block, find its loops, and write a page to look at");
  auto flags = std::make_shared<DemoFlags>();
  want_file_name(command
                     .add_option("-o,--output", flags->folder,
                                 "folder for the block and the page, made if it is missing")
                     ->type_name("FOLDER")
                     ->capture_default_str());
  add_progress_flags(command, flags->progress);
  command.footer(
      "Examples:\n"
      "  isoloop demo -o demo\n"
      "  isoloop demo --quiet\n"
      "  isoloop demo --log-json");
  command.callback([flags] { show(*flags); });
}

}  // namespace isoloop
