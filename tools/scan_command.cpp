#include "tools/scan_command.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <type_traits>
#include <variant>

#include <CLI/CLI.hpp>

#include "core/errors.h"
#include "core/scan.h"
#include "tools/number_text.h"
#include "tools/output_files.h"
#include "tools/progress.h"
#include "tools/read_run.h"
#include "tools/report_scan.h"
#include "tools/scan_plot.h"

namespace isoloop {
namespace {

constexpr int default_values = 256;
constexpr double most_integers = 1024;

struct ScanFlags {
  VolumeFlags volume;
  LevelFlags level;
  ScanRange range;
  ProgressFlags progress;
  std::string json;  // file, "-" or empty
  std::string csv;   // file, "-" or empty
  std::string svg;   // file, "-" or empty
};

bool holds_integers(const Volume& volume) {
  return std::visit(
      [](const auto& voxels) {
        return std::is_integral_v<typename std::decay_t<decltype(voxels)>::value_type>;
      },
      volume.values);
}

void scan(const ScanFlags& flags) {
  const auto start = std::chrono::steady_clock::now();
  OutputFiles outputs(flags.volume.file);
  outputs.add("--json", flags.json, write_scan_json);
  outputs.add("--csv", flags.csv, write_scan_csv);
  outputs.add("--svg", flags.svg, write_scan_svg);
  ProgressLine progress(std::cerr, progress_options(flags.progress));
  LevelFlags level = flags.level;
  level.iso = 0.0;  // stands in until an iso value is proposed
  RunResult run = read_run(flags.volume, level);
  run.with_loops = false;
  const std::vector<double> isos = scan_values(flags.range, run.volume, run.range);
  scan_run(run, isos, progress.callback());
  run.cost.total_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.cost.peak_bytes = peak_resident_bytes();
  progress.clear();
  outputs.write(run);
  if (!outputs.uses_stdout()) write_scan_table(std::cout, run);
  finish_stdout();
}

}  // namespace

std::vector<double> scan_values(const ScanRange& range, const Volume& volume,
                                const ValueRange& voxels) {
  constexpr double largest = 1e150;  // as core/level.h takes infinite values
  const double from = range.from.value_or(std::clamp(voxels.min, -largest, largest));
  const double to = range.to.value_or(std::clamp(voxels.max, -largest, largest));
  if (!std::isfinite(from) || !std::isfinite(to) || from > to)
    throw InvalidArgument("--from " + shortest_text(from) + " and --to " + shortest_text(to) +
                          " leave no iso value");
  if (range.values && (*range.values < 1 || *range.values > static_cast<int>(max_scan_values)))
    throw InvalidArgument("--values must be 1 to " + std::to_string(max_scan_values));
  const bool integers = holds_integers(volume);
  const double all = std::floor(to) - std::ceil(from) + 1;
  const bool take_all = integers && !range.values && all <= most_integers;
  const int count = range.values.value_or(take_all ? static_cast<int>(all) : default_values);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double share = count == 1 ? 0.5 : static_cast<double>(i) / (count - 1);
    const double value =
        take_all ? std::ceil(from) + i : from * (1 - share) + to * share;  // never beyond the ends
    values.push_back(integers ? std::round(value) : value);
  }
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (values.empty())
    throw InvalidArgument("--from " + shortest_text(from) + " and --to " + shortest_text(to) +
                          " leave no integer iso value");
  return values;
}

void scan_run(RunResult& run, const std::vector<double>& isos, const Progress& progress) {
  const Index3& dims = run.volume.dims;
  run.scan =
      scan_topology(view(run.volume), isos, {run.level.inside, run.level.topology, progress});
  run.plateaus = find_plateaus(run.scan, dims[0] * dims[1] * dims[2]);
  run.proposed = proposed_row(run.scan, run.plateaus);
}

void add_scan_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "scan", "count components, tunnels and cavities at all iso values, and propose one");
  auto flags = std::make_shared<ScanFlags>();
  add_volume_flags(command, flags->volume);
  add_convention_flags(command, flags->level);
  command
      .add_option("--values", flags->range.values,
                  "how many iso values to look at (default 256, or all integers of a small range)")
      ->type_name("N");
  command
      .add_option("--from", flags->range.from, "the least of them (default: the least voxel value)")
      ->type_name("VALUE");
  command
      .add_option("--to", flags->range.to, "the largest of them (default: the largest voxel value)")
      ->type_name("VALUE");
  command.add_option("--json", flags->json, "write the counts as JSON; - is standard output")
      ->type_name("FILE|-");
  command
      .add_option("--csv", flags->csv, "write one line for each iso value; - is standard output")
      ->type_name("FILE|-");
  command.add_option("--svg", flags->svg, "draw the counts as curves; - is standard output")
      ->type_name("FILE|-");
  add_progress_flags(command, flags->progress);
  command.footer(
      "Examples:\n"
      "  isoloop scan engine_256x256x128_uint8.raw --svg curves.svg\n"
      "  isoloop scan block.vdb --values 100 --from -2 --to 2 --csv curves.csv\n"
      "  isoloop scan scan.raw --dims 512 512 300 --type i16 --from 0 --json -");
  command.callback([flags] { scan(*flags); });
}

}  // namespace isoloop
