#include "tools/bench/stage_meter.h"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <utility>

#include <sys/resource.h>

#include "tools/runs/run_result.h"

namespace isoloop {
namespace {

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Of this process so far, all threads, and of its children, as those that read .vdb files.
double cpu_seconds() {
  timespec own{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &own);
  rusage children{};
  getrusage(RUSAGE_CHILDREN, &children);
  return static_cast<double>(own.tv_sec) + 1e-9 * static_cast<double>(own.tv_nsec) +
         seconds_of(children.ru_utime) + seconds_of(children.ru_stime);
}

/// From here on the largest resident set is counted anew, if the system allows that.
void set_back_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

}  // namespace

void StageMeter::enter(const std::string& stage) {
  if (!stages_.empty()) {
    if (stages_.back().name == stage) return;
    end_stage();
  }
  stages_.push_back({.name = stage});
  set_back_peak();
  wall_start_ = std::chrono::steady_clock::now();
  cpu_start_ = cpu_seconds();
}

std::vector<StageCost> StageMeter::end() {
  if (!stages_.empty()) end_stage();
  return std::exchange(stages_, {});
}

void StageMeter::end_stage() {
  StageCost& stage = stages_.back();
  stage.cpu_seconds = cpu_seconds() - cpu_start_;
  stage.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start_).count();
  stage.peak_bytes = peak_resident_bytes();
}

StageCost whole_of(const std::vector<StageCost>& stages) {
  StageCost whole{.name = "all"};
  for (const StageCost& stage : stages) {
    whole.cpu_seconds += stage.cpu_seconds;
    whole.wall_seconds += stage.wall_seconds;
    whole.peak_bytes = std::max(whole.peak_bytes, stage.peak_bytes);
  }
  return whole;
}

}  // namespace isoloop
