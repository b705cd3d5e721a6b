// One line on the terminal that says how far a long run has come.
#pragma once

#include <chrono>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>

#include "core/analysis.h"

namespace isoloop {

struct ProgressOptions {
  bool enabled = true;                           // false: stays silent
  std::chrono::milliseconds quiet{1000};         // after the start: nothing is shown before
  std::chrono::milliseconds between_lines{100};  // the least time from one line to the next
};

/// True if standard error is a terminal.
bool stderr_is_terminal();

/// Rewrites one line of `out` with the stage and its share. At most one line is ever there, and
/// none once the object is gone. Calls may come from any thread.
class ProgressLine {
 public:
  /// `out` must outlive the object.
  ProgressLine(std::ostream& out, const ProgressOptions& options);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `share_done` in [0, 1].
  void show(const char* stage, double share_done);

  /// Removes the line, so that something else can be written.
  void clear();

  /// For AnalysisOptions; valid while the object lives. Empty if not enabled.
  Progress callback();

 private:
  using Clock = std::chrono::steady_clock;

  void write_line(const std::lock_guard<std::mutex>& held);
  void wake_after_quiet(const std::stop_token& stop);

  std::ostream& out_;
  ProgressOptions options_;
  std::mutex mutex_;  // guards all below
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_line_{};
  std::string stage_;
  long percent_ = 0;
  std::size_t shown_ = 0;  // characters of the line now on the terminal
  std::jthread waker_;     // shows a stage that began in the quiet time; last, so it ends first
};

}  // namespace isoloop
