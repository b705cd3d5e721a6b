#include "tools/bench/measurement.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/base/errors.h"
#include "core/base/threads.h"
#include "tools/runs/memory_cap.h"
#include "volume/base/memory_limit.h"

namespace isoloop {
namespace {

using Json = nlohmann::ordered_json;

Measurement measured(const LoopsRun& run, const std::vector<StageCost>& stages) {
  return {.dims = run.volume.dims,
          .triangles = static_cast<std::int64_t>(run.analysis.surface.triangles.size()),
          .genus = run.analysis.surface.genus(),
          .loops = static_cast<std::int64_t>(run.analysis.loops.size()),
          .slowest_loops_seconds = run.analysis.seconds.slowest_loops,
          .whole = whole_of(stages),
          .stages = stages};
}

/// The stages start one after the other, each before the threads that work on it.
Progress told_to(StageMeter& meter) {
  return [&meter](const char* stage, double) { meter.enter(stage); };
}

RunInput made_shape(const std::string& name, ShapeOptions options, const LoopsInput& input) {
  const std::uint64_t available = default_voxel_limit();
  if (!input.volume.max_memory.empty()) {
    options.max_bytes = parse_bytes(input.volume.max_memory);
    cap_memory(options.max_bytes);
  }
  Shape shape = on_threads(input.threads, [&] { return make_shape(name, options); });
  RunInput run;
  run.file = name;
  run.volume = std::move(shape.volume);
  run.level = shape.level;
  const std::uint64_t limit = options.max_bytes > 0 ? options.max_bytes : available;
  run.cost.max_bytes = limit - std::min(limit, resident_bytes());
  return run;
}

}  // namespace

std::int64_t voxels_of(const Measurement& measurement) {
  return measurement.dims[0] * measurement.dims[1] * measurement.dims[2];
}

Measurement measure_file(const LoopsInput& input) {
  StageMeter meter;
  meter.enter("read");
  const LoopsRun run = find_run(input, told_to(meter));
  return measured(run, meter.end());
}

Measurement measure_shape(const std::string& name, const ShapeOptions& shape,
                          const LoopsInput& input) {
  RunInput made = made_shape(name, shape, input);
  StageMeter meter;
  const LoopsRun run = find_in(std::move(made), input, told_to(meter));
  return measured(run, meter.end());
}

std::string text_of(const Measurement& measurement) {
  Json stages = Json::array();
  for (const StageCost& stage : measurement.stages)
    stages.push_back({stage.name, stage.cpu_seconds, stage.wall_seconds, stage.peak_bytes});
  return Json{{"dims", measurement.dims},
              {"triangles", measurement.triangles},
              {"genus", measurement.genus},
              {"loops", measurement.loops},
              {"slowest_loops", measurement.slowest_loops_seconds},
              {"stages", stages}}
      .dump();
}

Measurement measurement_of(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    Measurement measurement{.dims = json.at("dims").get<Index3>(),
                            .triangles = json.at("triangles").get<std::int64_t>(),
                            .genus = json.at("genus").get<std::int64_t>(),
                            .loops = json.at("loops").get<std::int64_t>(),
                            .slowest_loops_seconds = json.at("slowest_loops").get<double>()};
    for (const Json& stage : json.at("stages"))
      measurement.stages.push_back({stage.at(0).get<std::string>(), stage.at(1).get<double>(),
                                    stage.at(2).get<double>(), stage.at(3).get<std::uint64_t>()});
    measurement.whole = whole_of(measurement.stages);
    return measurement;
  } catch (const Json::exception&) {
    throw SelfCheckFailed("a measured run ended without its figures");
  }
}

}  // namespace isoloop
