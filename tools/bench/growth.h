// What many measured runs show together: how cost grows, and how it spreads over threads.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tools/bench/measurement.h"

namespace isoloop {

/// A run for these tables: a row of `bench` that did not fail.
struct MeasuredRun {
  std::string volume{};
  std::int64_t size = 0;  // voxels along the longest axis
  int threads = 0;
  const Measurement* measured = nullptr;
};

/// A figure for each stage, by name; nothing where it cannot be told.
using ByStage = std::vector<std::pair<std::string, std::optional<double>>>;

/// How cost grows with the voxels of a volume, on one number of threads: the exponent e of
/// cost ~ voxels^e, the slope of the line of least squares through the logarithms of all sizes.
struct Growth {
  std::string volume{};
  int threads = 0;
  std::int64_t least_size = 0;  // voxels along the longest axis
  std::int64_t largest_size = 0;
  std::optional<double> wall{};
  std::optional<double> peak{};  // of memory
  ByStage cpu{};                 // "all", then each stage
};

/// One for each volume and number of threads that have two sizes or more, in their order. Times
/// below a millisecond say nothing.
std::vector<Growth> growth_of(std::span<const MeasuredRun> runs);

/// How much of the threads is used: the wall clock on the least number of threads, times that
/// number, over the same on more. 1: twice the threads, half the time.
struct Efficiency {
  std::string volume{};
  std::int64_t size = 0;  // voxels along the longest axis
  int threads = 0;
  int least_threads = 0;  // to which it is compared
  double speedup = 0.0;   // wall clock on the least, over that on these
  ByStage efficiency{};   // "all", then each stage
};

/// One for each volume, size and number of threads above its least, in their order.
std::vector<Efficiency> efficiency_of(std::span<const MeasuredRun> runs);

/// The cost of the stage; nothing where the run had no such stage. "all" is the whole run.
std::optional<StageCost> stage_of(const Measurement& measurement, const std::string& stage);

/// "all", then the stages of all runs in the order of the first that has them.
std::vector<std::string> stage_names(std::span<const MeasuredRun> runs);

}  // namespace isoloop
