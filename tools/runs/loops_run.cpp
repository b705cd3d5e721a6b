#include "tools/runs/loops_run.h"

#include <iostream>

#include "core/base/errors.h"
#include "core/base/stage.h"
#include "core/base/threads.h"
#include "tools/runs/read_run.h"
#include "tools/runs/scan_run.h"
#include "tools/words/sentence.h"

namespace isoloop {
namespace {

LoopsRun found_run(const LoopsInput& input, const Progress& progress) {
  const PairOptions pair = pair_options(input.engine);
  const Boundary boundary = boundary_of(input.level);
  const Tighten tighten = tighten_of(input.engine, boundary);
  LoopsRun run{{read_run(input.volume, input.level)}};
  run.geodesic = input.geodesic == "exact" ? GeodesicMode::exact : GeodesicMode::hierarchy;
  run.engine = engine_of(input.engine);
  run.refinement = pair.refinement;
  run.tighten = tighten;
  run.filter = input.filter;
  run.analysis = analyze(view(run.volume), run.level,
                         {.boundary = boundary,
                          .geodesic = run.geodesic,
                          .engine = run.engine,
                          .tighten = run.tighten,
                          .pair = pair,
                          .count_volume_triangles = input.engine.stats,
                          .progress = progress,
                          .max_bytes = run.cost.max_bytes});
  check_counts(run.analysis);
  check_loops(run.analysis);
  run.reported = select_loops(run.analysis.loops, input.filter);
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
      std::cerr << "isoloop: warning: features are left out: " << sentence_of(error.finding)
                << '\n';
    }
  }
  if (input.with_scan && boundary == Boundary::closed && !run.level.upper) {
    if (progress) progress("scan", 0.95);
    run.scan =
        in_stage("scan", [&] { return scan_of(run, scan_values({}, run.volume, run.range), {}); });
  }
  return run;
}

}  // namespace

void check_engine_flags(const LoopsInput& input) {
  pair_options(input.engine);
  tighten_of(input.engine, boundary_of(input.level));
}

LoopsRun find_run(const LoopsInput& input, const Progress& progress) {
  return about_file(input.volume.file, [&] {
    return on_threads(input.threads, [&] { return found_run(input, progress); });
  });
}

}  // namespace isoloop
