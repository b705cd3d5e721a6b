// One run of `loops` and what it takes, in this process.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/grid/grid.h"
#include "isoloop/shapes.h"
#include "tools/bench/stage_meter.h"
#include "tools/runs/loops_run.h"

namespace isoloop {

struct Measurement {
  Index3 dims{};  // voxels
  std::int64_t triangles = 0;
  std::int64_t genus = 0;
  std::int64_t loops = 0;
  double slowest_loops_seconds = 0.0;  // CPU, see StageSeconds
  StageCost whole{};                   // named "all"
  std::vector<StageCost> stages{};     // in their order; the first is "read", unless of a shape
};

std::int64_t voxels_of(const Measurement& measurement);

/// From reading to loops that are proved and checked; nothing is reported. Throws as find_run().
Measurement measure_file(const LoopsInput& input);

/// The same of a shape, whose making is not measured; `input` has no file. Throws as make_shape()
/// and find_run().
Measurement measure_shape(const std::string& name, const ShapeOptions& shape,
                          const LoopsInput& input);

/// As one line of JSON, which measurement_of() reads. That throws SelfCheckFailed for any other.
std::string text_of(const Measurement& measurement);
Measurement measurement_of(std::string_view text);

}  // namespace isoloop
