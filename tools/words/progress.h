// How far a long run has come: one line on the terminal, or JSON for programs.
#pragma once

#include <chrono>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>

#include "core/base/progress.h"
#include "tools/words/cli_app.h"

namespace isoloop {

/// As typed.
struct ProgressFlags {
  bool quiet = false;
  bool log_json = false;
  bool slicer = false;  // on standard output, as 3D Slicer reads it
};

/// Adds --quiet and --log-json, and --slicer, of which the help says nothing. `flags` must outlive
/// the parse.
void add_progress_flags(CLI::App& command, ProgressFlags& flags);

enum class ProgressForm { line, json, slicer };

struct ProgressOptions {
  bool enabled = true;                           // false: stays silent
  ProgressForm form = ProgressForm::line;        // others: one for each call, from the start
  std::chrono::milliseconds quiet{1000};         // after the start: no line is shown before
  std::chrono::milliseconds between_lines{100};  // the least time from one line to the next
};

/// A line where standard error is a terminal and --quiet is not given, JSON for --log-json.
ProgressOptions progress_options(const ProgressFlags& flags);

/// True if standard error is a terminal.
bool stderr_is_terminal();

/// "12 s", "3 min", "1.5 h".
std::string time_left_text(std::chrono::duration<double> left);

/// Rewrites one line of `out` with the stage, its share and the time left, again every second. At
/// most one line is ever there, and none once the object is gone. As JSON one object a line
/// instead: "event" ("progress"), "stage", "share", "seconds" since the start; for 3D Slicer two
/// elements of XML, <filter-comment> with the stage and <filter-progress> with the share. Calls may
/// come from any thread.
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
  void write_json(const std::lock_guard<std::mutex>& held);
  void write_slicer(const std::lock_guard<std::mutex>& held);
  void tick(const std::stop_token& stop);

  std::ostream& out_;
  ProgressOptions options_;
  std::mutex mutex_;  // guards all below
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_line_{};
  std::string stage_;
  double share_ = 0.0;
  std::chrono::duration<double> told_after_{};  // the start
  std::size_t shown_ = 0;                       // characters of the line now on the terminal
  std::jthread ticker_;  // shows the line again as time goes by; last, so it ends first
};

}  // namespace isoloop
