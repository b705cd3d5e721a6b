#include "tools/commands/convert_command.h"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "tools/flags/input_flags.h"
#include "tools/reports/report_table.h"
#include "tools/runs/output_files.h"
#include "tools/runs/read_run.h"
#include "tools/runs/report_run.h"
#include "tools/runs/written_volume.h"
#include "tools/words/flag_checks.h"
#include "tools/words/progress.h"
#include "volume/base/file_kind.h"
#include "volume/files/write.h"

namespace isoloop {
namespace {

struct ConvertFlags {
  VolumeFlags volume;
  ProgressFlags progress;
  std::string output;
};

RunInput converted_run(const ConvertFlags& flags) {
  RunInput run = read_input(flags.volume, VdbMargin::none);
  check_written("OUT", flags.output, run.volume);
  check_writer_memory("write", flags.output, run);
  warn_of_left_out(run, flags.output);
  return run;
}

void convert(const ConvertFlags& flags) {
  check_written_format("OUT", flags.output);  // before anything is read
  RunInput run;
  OutputFiles outputs(flags.volume.file);
  outputs.add("OUT", flags.output,
              [&](std::ostream& out) { write_volume(out, run.volume, flags.output); });
  run_and_report<RunInput>(flags.progress, outputs, run,
                           {.run = [&](const Progress&) { return converted_run(flags); },
                            .table =
                                [&](std::ostream& out, const RunInput& read) {
                                  out << flags.output << ": " << volume_text(read.volume) << '\n';
                                }});
}

}  // namespace

void add_convert_command(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("convert", "write a volume, or a mesh, in another format");
  auto flags = std::make_shared<ConvertFlags>();
  add_volume_flags(command, flags->volume);
  want_file_name(command.add_option("OUT", flags->output, "file to write: " + written_extensions())
                     ->type_name("")
                     ->required());
  add_progress_flags(command, flags->progress);
  command.footer(
      "Examples:\n"
      "  isoloop convert slices/ scan.nii.gz\n"
      "  isoloop convert scan.nii.gz part.nrrd --crop 10:90,:,20:\n"
      "  isoloop convert scan.raw scan.mha --dims 512 512 300 --type i16 --spacing 0.4mm");
  command.callback([flags] { convert(*flags); });
}

}  // namespace isoloop
