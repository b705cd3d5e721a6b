#include "tools/runs/loops_run.h"

#include <utility>

#include "core/base/errors.h"
#include "core/base/stage.h"
#include "core/base/threads.h"
#include "tools/flags/length_flag.h"
#include "tools/runs/frowns.h"
#include "tools/runs/read_run.h"
#include "tools/runs/scan_run.h"
#include "tools/words/sentence.h"

namespace isoloop {
namespace {

void set_sizes(LoopFilter& filter, const LoopsInput& input, const Volume& volume) {
  const auto set = [&](double& size, const std::string& text, const std::string& flag) {
    if (!text.empty()) size = length_in(parse_length(flag, text), volume, flag);
  };
  set(filter.min_size, input.min_size, "--min-size");
  set(filter.max_size, input.max_size, "--max-size");
  if (filter.min_size > filter.max_size)
    throw InvalidArgument("--min-size and --max-size leave nothing to report");
}

LoopsRun found_in(RunInput volume, const LoopsInput& input, const Progress& progress) {
  const PairOptions pair = pair_options(input.engine);
  const Boundary boundary = boundary_of(input.level);
  const Tighten tighten = tighten_of(input.engine, boundary);
  LoopsRun run{{std::move(volume)}};
  run.remark = spacing_note(run, !input.volume.spacing.empty());
  run.geodesic = input.geodesic == "exact" ? GeodesicMode::exact : GeodesicMode::hierarchy;
  run.engine = engine_of(input.engine);
  run.refinement = pair.refinement;
  run.grading = grading_of(input.engine);
  run.tighten = tighten;
  run.filter = input.filter;
  set_sizes(run.filter, input, run.volume);
  run.analysis = analyze(voxels_of(run), run.level,
                         {.boundary = boundary,
                          .geodesic = run.geodesic,
                          .engine = run.engine,
                          .complex = complex_of(input.engine),
                          .grading = run.grading,
                          .tighten = run.tighten,
                          .pair = pair,
                          .count_volume_triangles = input.engine.stats,
                          .progress = progress,
                          .max_bytes = run.cost.max_bytes});
  if (progress) progress("checks", 0.92);
  check_counts(run.analysis);
  check_loops(run.analysis);
  for (std::string& warning : count_warnings(run, run.analysis))
    add_warning(run, std::move(warning));
  run.reported = select_loops(run.analysis.loops, run.filter);
  if (input.features && boundary == Boundary::closed) {
    if (progress) progress("features", 0.93);
    FeatureOptions options = *input.features;
    options.max_bytes = run.cost.max_bytes;
    try {
      run.features = in_stage("features", [&] {
        return features_of(run.analysis.surface, run.analysis.loops, options);
      });
    } catch (const LimitExceeded& error) {
      if (!input.features_may_lack) throw;
      add_warning(run, "features are left out: " + sentence_of(error.finding));
    }
  }
  if (input.with_scan && boundary == Boundary::closed && !run.level.upper) {
    if (progress) progress("scan", 0.95);
    run.scan = in_stage(
        "scan", [&] { return scan_of(run, scan_values({}, voxels_of(run), run.range), {}); });
  }
  return run;
}

}  // namespace

void check_engine_flags(const LoopsInput& input) {
  complex_of(input.engine);
  pair_options(input.engine);
  tighten_of(input.engine, boundary_of(input.level));
}

LoopsRun find_run(const LoopsInput& input, const Progress& progress) {
  check_engine_flags(input);
  return about_file(input.volume.file, [&] {
    return on_threads(input.threads, [&] {
      return found_in(read_run(input.volume, input.level), input, progress);
    });
  });
}

LoopsRun find_in(RunInput volume, const LoopsInput& input, const Progress& progress) {
  return on_threads(input.threads, [&] { return found_in(std::move(volume), input, progress); });
}

}  // namespace isoloop
