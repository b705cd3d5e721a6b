#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "tools/bench/bench_flags.h"
#include "tools/bench/measurement.h"
#include "tools/bench/own_process.h"
#include "tools/commands/bench_command.h"
#include "tools/flags/thread_flag.h"
#include "tools/runs/output_files.h"

namespace isoloop {
namespace {

struct MeasureFlags {
  LoopsInput input;
  std::string shape;  // as parse_shape() reads it; empty: a file
  std::int64_t size = 128;
};

void measure(const MeasureFlags& flags) {
  end_with_parent();
  if (flags.shape.empty() == flags.input.volume.file.empty())
    throw InvalidArgument("measure wants either --shape or --file");
  Measurement measurement;
  if (flags.shape.empty()) {
    measurement = measure_file(flags.input);
  } else {
    NamedShape shape = parse_shape(flags.shape);
    shape.options.size = flags.size;
    measurement = measure_shape(shape.name, shape.options, flags.input);
  }
  std::cout << text_of(measurement) << '\n';
  finish_stdout();
}

}  // namespace

void add_measure_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("measure", "one run of bench");
  command.group("");  // not in the help
  auto flags = std::make_shared<MeasureFlags>();
  command.add_option("--shape", flags->shape, "shape to find loops of")->type_name("NAME[:N]");
  command.add_option("--size", flags->size, "voxels along its longest axis")->type_name("N");
  add_thread_flag(command, flags->input.threads);
  add_measured_flags(command, flags->input);
  command.callback([flags] { measure(*flags); });
}

}  // namespace isoloop
