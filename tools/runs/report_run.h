// The course of every command that reports: a run, its files, then its table.
#pragma once

#include <chrono>
#include <concepts>
#include <functional>
#include <iostream>

#include "core/base/progress.h"
#include "tools/runs/output_files.h"
#include "tools/runs/run_result.h"
#include "tools/words/progress.h"

namespace isoloop {

template <class Result>
struct Course {
  std::function<Result(const Progress&)> run;  // from flags to a result that is checked
  std::function<void(Result&)> settle{};       // before anything is reported: warnings, the volume
  std::function<void(std::ostream&, const Result&)> table;  // for people
};

/// Fills `result`, which the reports of `outputs` refer to, tells its warnings on standard error
/// and writes the reports; then the table, where no report has standard output. Throws what the
/// steps throw, and as OutputFiles::write() and finish_stdout() do.
template <class Result>
void run_and_report(const ProgressFlags& flags, const OutputFiles& outputs, Result& result,
                    const Course<Result>& course) {
  const auto start = std::chrono::steady_clock::now();
  ProgressLine progress(flags.slicer ? std::cout : std::cerr, progress_options(flags));
  result = course.run(progress.callback());
  if constexpr (std::derived_from<Result, RunInput>)
    outputs.check_apart_from(result.volume.data_file);
  result.cost.peak_bytes = peak_resident_bytes();
  progress.clear();
  if (course.settle) course.settle(result);
  if constexpr (std::derived_from<Result, RunInput>) tell_warnings(std::cerr, result);
  result.cost.total_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outputs.write();
  if (!outputs.uses_stdout()) course.table(std::cout, result);
  finish_stdout();
}

}  // namespace isoloop
