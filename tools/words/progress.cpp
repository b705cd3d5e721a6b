#include "tools/words/progress.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "tools/words/number_text.h"

namespace isoloop {

void add_progress_flags(CLI::App& command, ProgressFlags& flags) {
  CLI::Option* quiet =
      command.add_flag("--quiet", flags.quiet, "show no progress on standard error");
  command
      .add_flag("--log-json", flags.log_json,
                "write progress and errors to standard error as JSON, one object a line")
      ->excludes(quiet);
  command.add_flag("--slicer", flags.slicer)->group("");
}

ProgressOptions progress_options(const ProgressFlags& flags) {
  ProgressOptions options;
  options.enabled = flags.slicer || flags.log_json || (!flags.quiet && stderr_is_terminal());
  if (flags.log_json) options.form = ProgressForm::json;
  if (flags.slicer) options.form = ProgressForm::slicer;
  return options;
}

bool stderr_is_terminal() { return isatty(STDERR_FILENO) == 1; }

std::string time_left_text(std::chrono::duration<double> left) {
  const double seconds = std::max(left.count(), 0.0);
  if (seconds < 90) return std::to_string(std::lround(seconds)) + " s";
  if (seconds < 5400) return std::to_string(std::lround(seconds / 60)) + " min";
  return fixed_text(seconds / 3600, 1) + " h";
}

ProgressLine::ProgressLine(std::ostream& out, const ProgressOptions& options)
    : out_(out), options_(options) {
  if (options.enabled && options.form == ProgressForm::line) {
    ticker_ = std::jthread([this](const std::stop_token& stop) { tick(stop); });
  }
}

ProgressLine::~ProgressLine() {
  ticker_.request_stop();
  if (ticker_.joinable()) ticker_.join();
  clear();
}

void ProgressLine::show(const char* stage, double share_done) {
  if (!options_.enabled) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  const bool same_stage = stage_ == stage;
  stage_ = stage;
  share_ = share_done > 0.0 ? std::min(share_done, 1.0) : 0.0;  // NaN counts as 0
  told_after_ = now - start_;
  const bool too_soon = same_stage && now - last_line_ < options_.between_lines;
  if (options_.form == ProgressForm::json) {
    if (!too_soon) write_json(lock);
    return;
  }
  if (options_.form == ProgressForm::slicer) {
    if (!too_soon) write_slicer(lock);
    return;
  }
  if (now - start_ < options_.quiet) return;
  if (too_soon && shown_ > 0) return;
  write_line(lock);
}

void ProgressLine::clear() {
  const std::lock_guard lock(mutex_);
  stage_.clear();
  if (shown_ == 0) return;
  out_ << '\r' << std::string(shown_, ' ') << '\r' << std::flush;
  shown_ = 0;
}

Progress ProgressLine::callback() {
  if (!options_.enabled) return {};
  return [this](const char* stage, double share_done) { show(stage, share_done); };
}

void ProgressLine::write_line(const std::lock_guard<std::mutex>&) {
  std::string line =
      "isoloop: " + stage_ + ' ' + std::to_string(std::lround(100.0 * share_)) + " %";
  // Too early to tell otherwise.
  if (share_ >= 0.05 && share_ < 1.0 && told_after_ >= std::chrono::seconds(1)) {
    const std::chrono::duration<double> passed = Clock::now() - start_;
    line += ", about " + time_left_text(told_after_ / share_ - passed) + " left";
  }
  const std::size_t blanks = shown_ > line.size() ? shown_ - line.size() : 0;
  out_ << '\r' << line << std::string(blanks, ' ') << std::flush;
  shown_ = line.size() + blanks;
  last_line_ = Clock::now();
}

void ProgressLine::write_json(const std::lock_guard<std::mutex>&) {
  const nlohmann::ordered_json event = {{"event", "progress"},
                                        {"stage", stage_},
                                        {"share", share_},
                                        {"seconds", told_after_.count()}};
  out_ << event.dump() + '\n' << std::flush;
  last_line_ = Clock::now();
}

void ProgressLine::write_slicer(const std::lock_guard<std::mutex>&) {
  out_ << "<filter-comment>" << stage_ << "</filter-comment>\n<filter-progress>"
       << fixed_text(share_, 3) << "</filter-progress>\n"
       << std::flush;
  last_line_ = Clock::now();
}

void ProgressLine::tick(const std::stop_token& stop) {
  constexpr std::chrono::seconds between_ticks{1};
  std::mutex asleep;
  std::condition_variable_any stopped;
  for (Clock::time_point next = start_ + options_.quiet;; next += between_ticks) {
    {
      std::unique_lock lock(asleep);
      stopped.wait_until(lock, stop, next, [] { return false; });
    }
    if (stop.stop_requested()) return;
    const std::lock_guard lock(mutex_);
    if (!stage_.empty() && Clock::now() - last_line_ >= options_.between_lines) write_line(lock);
  }
}

}  // namespace isoloop
