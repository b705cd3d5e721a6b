#include "tools/loops_command.h"

#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>

#include "core/errors.h"
#include "tools/engine_flags.h"
#include "tools/output_files.h"
#include "tools/progress.h"
#include "tools/read_run.h"
#include "tools/report_csv.h"
#include "tools/report_json.h"
#include "tools/report_mesh.h"
#include "tools/report_pairs.h"
#include "tools/report_stats.h"
#include "tools/report_table.h"

namespace isoloop {
namespace {

struct LoopsFlags {
  VolumeFlags volume;
  LevelFlags level;
  EngineFlags engine;
  std::string json;  // file, "-" or empty
  std::string csv;   // file, "-" or empty
  std::string ply;   // file or empty
  int threads = 0;   // 0: one for each core
  LoopFilter filter;
  std::string side = "both";
  std::string geodesic = "hierarchy";
};

LoopFilter filter_of(const LoopsFlags& flags) {
  LoopFilter filter = flags.filter;
  filter.handles = flags.side != "tunnel";
  filter.tunnels = flags.side != "handle";
  if (flags.level.open_boundary && flags.side != "both") {
    throw InvalidArgument("--side " + flags.side +
                          " does not go with --open-boundary, which tells no sides apart");
  }
  if (std::isnan(filter.min_size) || std::isnan(filter.max_size) ||
      filter.min_size > filter.max_size) {
    throw InvalidArgument("--min-size and --max-size leave nothing to report");
  }
  return filter;
}

void find(const LoopsFlags& flags) {
  const auto start = std::chrono::steady_clock::now();
  const LoopFilter filter = filter_of(flags);
  const PairOptions pair = pair_options(flags.engine);
  const Tighten tighten = tighten_of(flags.engine, boundary_of(flags.level));
  OutputFiles outputs(flags.volume.file);
  outputs.add("--json", flags.json, write_json);
  outputs.add("--csv", flags.csv, write_csv);
  outputs.add("--ply", flags.ply,
              [](std::ostream& out, const RunResult& run) { write_ply(out, run); });
  outputs.add("--dump-pairs", flags.engine.dump_pairs, write_pairs);
  std::optional<tbb::global_control> threads;
  if (flags.threads > 0) {
    threads.emplace(tbb::global_control::max_allowed_parallelism,
                    static_cast<std::size_t>(flags.threads));
  }
  ProgressLine progress(std::cerr, {.enabled = stderr_is_terminal()});

  RunResult run = read_run(flags.volume, flags.level);
  run.geodesic = flags.geodesic == "exact" ? GeodesicMode::exact : GeodesicMode::hierarchy;
  run.engine = engine_of(flags.engine);
  run.refinement = pair.refinement;
  run.tighten = tighten;
  run.filter = filter;
  run.analysis = find_loops(view(run.volume), run.level,
                            {.boundary = boundary_of(flags.level),
                             .geodesic = run.geodesic,
                             .engine = run.engine,
                             .tighten = run.tighten,
                             .pair = pair,
                             .count_volume_triangles = flags.engine.stats,
                             .progress = progress.callback(),
                             .max_bytes = run.cost.max_bytes});
  check_counts(run.analysis);
  check_loops(run.analysis);
  run.reported = select_loops(run.analysis.loops, filter);
  run.cost.total_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.cost.peak_bytes = peak_resident_bytes();
  progress.clear();

  outputs.write(run);
  if (!outputs.uses_stdout()) write_table(std::cout, run);
  if (flags.engine.stats) write_stats(outputs.uses_stdout() ? std::cerr : std::cout << '\n', run);
  finish_stdout();
}

void add_report_flags(CLI::App& command, LoopsFlags& flags) {
  command
      .add_option("--min-size", flags.filter.min_size,
                  "report loops of this size and more only, in the unit of the spacing")
      ->type_name("SIZE");
  command
      .add_option("--max-size", flags.filter.max_size,
                  "report loops of this size and less only, in the unit of the spacing")
      ->type_name("SIZE");
  command.add_option("--side", flags.side, "report loops of this kind only")
      ->check(CLI::IsMember({"handle", "tunnel", "both"}))
      ->type_name("KIND")
      ->capture_default_str();
  command.add_option("--json", flags.json, "write counts and loops as JSON; - is standard output")
      ->type_name("FILE|-");
  command.add_option("--csv", flags.csv, "write one line for each loop; - is standard output")
      ->type_name("FILE|-");
  command
      .add_option(
          "--ply", flags.ply,
          "write the surface as a mesh, handle loops green, tunnel loops red, loops of neither "
          "kind blue")
      ->type_name("FILE");
}

}  // namespace

void add_loops_command(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("loops", "find, prove and measure every handle loop and tunnel loop");
  auto flags = std::make_shared<LoopsFlags>();
  add_volume_flags(command, flags->volume);
  add_level_flags(command, flags->level);
  command
      .add_option("--geodesic", flags->geodesic,
                  "how sizes are measured: exact is the definition to the letter and slow on thick "
                  "parts, hierarchy is exact up to five voxels")
      ->check(CLI::IsMember({"hierarchy", "exact"}))
      ->type_name("HOW")
      ->capture_default_str();
  command
      .add_option("--threads", flags->threads,
                  "threads to use (default: one for each core); the result does not depend on it")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  add_engine_flags(command, flags->engine);
  add_report_flags(command, *flags);
  command.footer(
      "Examples:\n"
      "  isoloop loops engine_256x256x128_uint8.raw --iso 70 --ply loops.ply\n"
      "  isoloop loops part.vdb --side tunnel --max-size 12 --csv holes.csv\n"
      "  isoloop loops scan.raw --dims 512 512 300 --type i16 --iso 400 --json - > loops.json");
  command.callback([flags] { find(*flags); });
}

}  // namespace isoloop
