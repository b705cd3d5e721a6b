// A run of `bench`: many runs, each in a process of its own, and what they come to.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "tools/bench/growth.h"
#include "tools/bench/machine.h"
#include "tools/bench/measurement.h"
#include "tools/bench/own_process.h"
#include "tools/runs/run_result.h"

namespace isoloop {

/// A volume to measure.
struct BenchCase {
  std::string volume{};                  // as the reports name it
  std::int64_t size = 0;                 // voxels along the longest axis; 0: not known beforehand
  std::vector<std::string> arguments{};  // of `isoloop measure`, but for --threads
};

struct BenchPlan {
  std::vector<BenchCase> cases{};
  std::vector<int> threads{};  // each case runs on each of these
  int repeat = 1;              // runs of each, of which the reports have medians
  double max_seconds = 0.0;    // wall clock of a run; 0: as long as it takes
};

/// What all runs of a case on one number of threads come to.
struct BenchRow {
  std::string volume{};
  std::int64_t size = 0;  // voxels along the longest axis; 0: the volume was not even read
  int threads = 0;
  Measurement median{};   // of each figure by itself; empty if a run failed
  std::string failure{};  // the sentence of a run that failed; empty: none did
  int exit_code = 0;      // of the run that failed, 128 + signal
};

struct BenchRun {
  Machine machine{};
  int repeat = 1;
  std::vector<BenchRow> rows{};
  std::vector<Growth> growth{};
  std::vector<Efficiency> efficiency{};
  RunCost cost{};
};

/// Runs `isoloop measure` with arguments, to its end or a limit.
using MeasuringRun = std::function<ProcessEnd(const std::vector<std::string>&, double max_seconds)>;

/// Measures the cases one after the other, so that none has another beside it. A run that fails
/// ends its case on that number of threads with a row that says why. What runs warn of goes to
/// standard error, once for each case. Throws what `run` throws.
BenchRun bench(const BenchPlan& plan, const MeasuringRun& run, const Progress& progress);

/// Of each figure by itself; of an even number of them the mean of the middle two. `runs`: not
/// empty, of one volume.
Measurement median_of(const std::vector<Measurement>& runs);

}  // namespace isoloop
