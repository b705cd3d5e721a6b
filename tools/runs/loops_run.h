// A run of `loops` or `view`, from flags to proved loops.
#pragma once

#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/loops/features.h"
#include "tools/flags/engine_flags.h"
#include "tools/flags/input_flags.h"
#include "tools/runs/run_result.h"

namespace isoloop {

/// As typed.
struct LoopsInput {
  VolumeFlags volume;
  LevelFlags level;
  EngineFlags engine;
  std::string geodesic = "hierarchy";
  int threads = 0;       // 0: one for each core
  LoopFilter filter;     // but for its sizes
  std::string min_size;  // "3", "3mm" or empty: none
  std::string max_size;
  bool with_scan = false;  // also count at many iso values, unless the boundary is open
  std::optional<FeatureOptions> features{};  // also sweep the features, unless the boundary is open
  bool features_may_lack = false;            // with a warning, where memory has no room for them
};

/// Throws InvalidArgument for engine flags that do not go together, before anything is read.
void check_engine_flags(const LoopsInput& input);

/// Reads the volume, finds, proves and checks all loops and selects those to report. Throws as
/// read_run(), analyze(), check_counts() and check_loops() do, and InvalidArgument for flags
/// that do not go together.
LoopsRun find_run(const LoopsInput& input, const Progress& progress);

/// The same in a volume that is there already, with its level; of `input` what it says of files is
/// not looked at, nor of levels but for the boundary.
LoopsRun find_in(RunInput volume, const LoopsInput& input, const Progress& progress);

}  // namespace isoloop
