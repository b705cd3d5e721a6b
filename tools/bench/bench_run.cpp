#include "tools/bench/bench_run.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <utility>

#include "tools/words/exit_code.h"
#include "tools/words/number_text.h"

namespace isoloop {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

template <class Figure>
double median_over(const std::vector<Measurement>& runs, const Figure& figure) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const Measurement& run : runs) values.push_back(static_cast<double>(figure(run)));
  return median(std::move(values));
}

/// Of what a failed run wrote to standard error: its last line, without the program's name.
std::string sentence_in(std::string err) {
  constexpr std::string_view name = "isoloop: ";
  while (!err.empty() && err.back() == '\n') err.pop_back();
  err.erase(0, err.rfind('\n') + 1);
  if (err.starts_with(name)) err.erase(0, name.size());
  return err;
}

std::string failure_in(const ProcessEnd& end, double max_seconds) {
  if (end.out_of_time) return "not done after " + shortest_text(max_seconds) + " s";
  if (end.exit_code <= 128 && !end.err.empty()) return sentence_in(end.err);
  if (end.exit_code <= 128) return "ended with exit code " + std::to_string(end.exit_code);
  const int signal = end.exit_code - 128;
  return "ended by signal " + std::to_string(signal) +
         (signal == 9 ? ", as where the system runs out of memory" : "");
}

/// How far the runs have come; a run is taken to last as long as it has voxels.
class BenchProgress {
 public:
  BenchProgress(const BenchPlan& plan, const Progress& progress)
      : plan_(plan), progress_(progress) {
    for (const BenchCase& one : plan.cases)
      whole_ += weight(one) * static_cast<double>(plan.threads.size()) * plan.repeat;
  }

  void start(const BenchCase& one, int threads, int run) {
    if (!progress_) return;
    std::string text = one.volume;
    if (one.size > 0) text.append(" ").append(std::to_string(one.size));
    text.append(" on ").append(counted(threads, "thread", "threads"));
    if (plan_.repeat > 1)
      text.append(", run ")
          .append(std::to_string(run + 1))
          .append(" of ")
          .append(std::to_string(plan_.repeat));
    progress_(text.c_str(), done_ / whole_);
    done_ += weight(one);
  }

 private:
  static double weight(const BenchCase& one) {
    constexpr double unknown_size = 128.0;
    const double size = one.size > 0 ? static_cast<double>(one.size) : unknown_size;
    return size * size * size;
  }

  const BenchPlan& plan_;
  const Progress& progress_;
  double whole_ = 0.0;
  double done_ = 0.0;
};

/// A case on one number of threads, while its runs come in.
struct OpenRow {
  BenchRow row{};
  std::vector<Measurement> runs{};
};

void add_run(OpenRow& open, const ProcessEnd& end, double max_seconds) {
  if (end.exit_code == static_cast<int>(ExitCode::done)) {
    open.runs.push_back(measurement_of(end.out));
    return;
  }
  open.row.failure = failure_in(end, max_seconds);
  open.row.exit_code = end.exit_code;
}

BenchRow closed(OpenRow open) {
  if (!open.row.failure.empty()) return std::move(open.row);
  open.row.median = median_of(open.runs);
  const Index3& dims = open.row.median.dims;
  if (open.row.size == 0) open.row.size = *std::max_element(dims.begin(), dims.end());
  return std::move(open.row);
}

std::vector<BenchRow> rows_of(const BenchCase& one, const BenchPlan& plan, const MeasuringRun& run,
                              BenchProgress& told) {
  std::vector<OpenRow> open;
  for (const int threads : plan.threads)
    open.push_back({{.volume = one.volume, .size = one.size, .threads = threads}, {}});
  bool has_warned = false;
  for (int repeat = 0; repeat < plan.repeat; ++repeat) {
    for (OpenRow& row : open) {
      told.start(one, row.row.threads, repeat);
      if (!row.row.failure.empty()) continue;
      std::vector<std::string> arguments = one.arguments;
      arguments.push_back("--threads=" + std::to_string(row.row.threads));
      const ProcessEnd end = run(arguments, plan.max_seconds);
      add_run(row, end, plan.max_seconds);
      if (row.row.failure.empty() && !std::exchange(has_warned, true)) std::cerr << end.err;
    }
  }
  std::vector<BenchRow> rows;
  rows.reserve(open.size());
  for (OpenRow& row : open) rows.push_back(closed(std::move(row)));
  return rows;
}

}  // namespace

Measurement median_of(const std::vector<Measurement>& runs) {
  Measurement result = runs.front();
  result.slowest_loops_seconds =
      median_over(runs, [](const Measurement& run) { return run.slowest_loops_seconds; });
  const auto settle = [&runs](StageCost& cost, const auto& of) {
    cost.cpu_seconds = median_over(runs, [&](const auto& run) { return of(run).cpu_seconds; });
    cost.wall_seconds = median_over(runs, [&](const auto& run) { return of(run).wall_seconds; });
    cost.peak_bytes = static_cast<std::uint64_t>(
        median_over(runs, [&](const auto& run) { return of(run).peak_bytes; }));
  };
  settle(result.whole, [](const Measurement& run) { return run.whole; });
  for (std::size_t s = 0; s < result.stages.size(); ++s)
    settle(result.stages[s], [s](const Measurement& run) { return run.stages.at(s); });
  return result;
}

BenchRun bench(const BenchPlan& plan, const MeasuringRun& run, const Progress& progress) {
  BenchRun result{.machine = this_machine(), .repeat = plan.repeat};
  BenchProgress told(plan, progress);
  for (const BenchCase& one : plan.cases)
    for (BenchRow& row : rows_of(one, plan, run, told)) result.rows.push_back(std::move(row));
  std::vector<MeasuredRun> measured;
  for (const BenchRow& row : result.rows)
    if (row.failure.empty()) measured.push_back({row.volume, row.size, row.threads, &row.median});
  result.growth = growth_of(measured);
  result.efficiency = efficiency_of(measured);
  return result;
}

}  // namespace isoloop
