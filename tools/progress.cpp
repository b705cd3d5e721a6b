#include "tools/progress.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>

#include <unistd.h>

namespace isoloop {

bool stderr_is_terminal() { return isatty(STDERR_FILENO) == 1; }

ProgressLine::ProgressLine(std::ostream& out, const ProgressOptions& options)
    : out_(out), options_(options) {
  if (options.enabled) {
    waker_ = std::jthread([this](const std::stop_token& stop) { wake_after_quiet(stop); });
  }
}

ProgressLine::~ProgressLine() {
  waker_.request_stop();
  if (waker_.joinable()) waker_.join();
  clear();
}

void ProgressLine::show(const char* stage, double share_done) {
  if (!options_.enabled) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  const bool same_stage = stage_ == stage;
  const double share = share_done > 0.0 ? std::min(share_done, 1.0) : 0.0;  // NaN counts as 0
  stage_ = stage;
  percent_ = std::lround(100.0 * share);
  if (now - start_ < options_.quiet) return;
  if (same_stage && shown_ > 0 && now - last_line_ < options_.between_lines) return;
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
  std::string line = "isoloop: ";
  line += stage_ + " " + std::to_string(percent_) + " %";
  const std::size_t blanks = shown_ > line.size() ? shown_ - line.size() : 0;
  out_ << '\r' << line << std::string(blanks, ' ') << std::flush;
  shown_ = line.size() + blanks;
  last_line_ = Clock::now();
}

void ProgressLine::wake_after_quiet(const std::stop_token& stop) {
  std::mutex asleep;
  std::condition_variable_any stopped;
  {
    std::unique_lock lock(asleep);
    stopped.wait_until(lock, stop, start_ + options_.quiet, [] { return false; });
  }
  if (stop.stop_requested()) return;
  const std::lock_guard lock(mutex_);
  if (!stage_.empty() && shown_ == 0) write_line(lock);
}

}  // namespace isoloop
