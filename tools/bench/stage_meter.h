// What the stages of a run take, in this process.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace isoloop {

struct StageCost {
  std::string name{};            // as Progress tells it
  double cpu_seconds = 0.0;      // user + system, of all threads and of children that have ended
  double wall_seconds = 0.0;     // wall clock
  std::uint64_t peak_bytes = 0;  // largest resident set within the stage
};

/// Times stages one after the other. Invariant: every moment from the first enter() to end() is in
/// one stage. The system's own mark of the largest resident set, which never falls, is set back at
/// the start of each stage; where the system does not allow that, a stage has the largest set up to
/// its end.
class StageMeter {
 public:
  /// Ends the stage before, unless it has the same name.
  void enter(const std::string& stage);

  /// Ends the last stage.
  std::vector<StageCost> end();

 private:
  void end_stage();

  std::vector<StageCost> stages_{};
  double cpu_start_ = 0.0;  // seconds
  std::chrono::steady_clock::time_point wall_start_{};
};

/// The sum of times, and the largest peak; named "all".
StageCost whole_of(const std::vector<StageCost>& stages);

}  // namespace isoloop
