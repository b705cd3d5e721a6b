#include "tools/bench/growth.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace isoloop {
namespace {

constexpr double least_seconds = 1e-3;

/// Of y over x, both logarithms; nothing unless there are two x or more.
std::optional<double> slope(const std::vector<std::pair<double, double>>& points) {
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (const auto& [x, y] : points) {
    mean_x += x / static_cast<double>(points.size());
    mean_y += y / static_cast<double>(points.size());
  }
  double xx = 0.0;
  double xy = 0.0;
  for (const auto& [x, y] : points) {
    xx += (x - mean_x) * (x - mean_x);
    xy += (x - mean_x) * (y - mean_y);
  }
  return xx > 0.0 ? std::optional(xy / xx) : std::nullopt;
}

using Figure = std::function<double(const Measurement&)>;

/// Nothing where a figure is below `least`.
std::optional<double> exponent(const std::vector<MeasuredRun>& sizes, double least,
                               const Figure& figure) {
  std::vector<std::pair<double, double>> points;
  for (const MeasuredRun& run : sizes) {
    const double value = figure(*run.measured);
    if (!(value >= least)) return std::nullopt;
    points.emplace_back(std::log(static_cast<double>(voxels_of(*run.measured))), std::log(value));
  }
  return slope(points);
}

Growth growth_over(const std::vector<MeasuredRun>& sizes) {
  Growth growth{.volume = sizes.front().volume,
                .threads = sizes.front().threads,
                .least_size = sizes.front().size,
                .largest_size = sizes.front().size};
  for (const MeasuredRun& run : sizes) {
    growth.least_size = std::min(growth.least_size, run.size);
    growth.largest_size = std::max(growth.largest_size, run.size);
  }
  growth.wall =
      exponent(sizes, least_seconds, [](const Measurement& m) { return m.whole.wall_seconds; });
  growth.peak = exponent(
      sizes, 1.0, [](const Measurement& m) { return static_cast<double>(m.whole.peak_bytes); });
  for (const std::string& name : stage_names(sizes))
    growth.cpu.emplace_back(name, exponent(sizes, least_seconds, [&name](const Measurement& m) {
                              const std::optional<StageCost> stage = stage_of(m, name);
                              return stage ? stage->cpu_seconds : 0.0;
                            }));
  return growth;
}

Efficiency efficiency_over(const MeasuredRun& least, const MeasuredRun& run) {
  Efficiency result{.volume = run.volume,
                    .size = run.size,
                    .threads = run.threads,
                    .least_threads = least.threads};
  const double factor = static_cast<double>(run.threads) / least.threads;
  const std::vector<MeasuredRun> both{least, run};
  for (const std::string& name : stage_names(both)) {
    const std::optional<StageCost> before = stage_of(*least.measured, name);
    const std::optional<StageCost> after = stage_of(*run.measured, name);
    const bool is_known = before && after && before->wall_seconds >= least_seconds &&
                          after->wall_seconds >= least_seconds;
    result.efficiency.emplace_back(
        name, is_known ? std::optional(before->wall_seconds / (factor * after->wall_seconds))
                       : std::nullopt);
  }
  const double wall = run.measured->whole.wall_seconds;
  if (wall > 0.0) result.speedup = least.measured->whole.wall_seconds / wall;
  return result;
}

}  // namespace

std::vector<Growth> growth_of(std::span<const MeasuredRun> runs) {
  std::vector<std::vector<MeasuredRun>> groups;
  for (const MeasuredRun& run : runs) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&run](const auto& other) {
      return other.front().volume == run.volume && other.front().threads == run.threads;
    });
    if (group == groups.end()) {
      groups.push_back({run});
    } else {
      group->push_back(run);
    }
  }
  std::vector<Growth> growth;
  for (const std::vector<MeasuredRun>& sizes : groups) {
    Growth one = growth_over(sizes);
    if (one.least_size < one.largest_size) growth.push_back(std::move(one));
  }
  return growth;
}

std::vector<Efficiency> efficiency_of(std::span<const MeasuredRun> runs) {
  std::vector<Efficiency> efficiency;
  for (const MeasuredRun& run : runs) {
    const MeasuredRun* least = &run;
    for (const MeasuredRun& other : runs)
      if (other.volume == run.volume && other.size == run.size && other.threads < least->threads)
        least = &other;
    if (least->threads < run.threads) efficiency.push_back(efficiency_over(*least, run));
  }
  return efficiency;
}

std::optional<StageCost> stage_of(const Measurement& measurement, const std::string& stage) {
  if (stage == "all") return measurement.whole;
  for (const StageCost& cost : measurement.stages)
    if (cost.name == stage) return cost;
  return std::nullopt;
}

std::vector<std::string> stage_names(std::span<const MeasuredRun> runs) {
  std::vector<std::string> names{"all"};
  for (const MeasuredRun& run : runs) {
    std::size_t place = 0;  // after the stage before, which other runs may lack
    for (const StageCost& stage : run.measured->stages) {
      const auto found = std::find(names.begin(), names.end(), stage.name);
      if (found == names.end())
        names.insert(names.begin() + static_cast<std::ptrdiff_t>(++place), stage.name);
      else
        place = static_cast<std::size_t>(found - names.begin());
    }
  }
  return names;
}

}  // namespace isoloop
