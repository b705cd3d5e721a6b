// A program that runs beside this one, for work that may go wrong in any way.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace isoloop {

/// What a child asks of the system for itself before it does anything else; in its arguments.
struct ChildLimits {
  std::uint64_t memory_bytes = 0;  // of data; beyond it allocations fail
  std::uint64_t cpu_seconds = 0;   // beyond them the system ends it
};

/// How a child ended.
struct ChildEnd {
  enum class How { exited, crashed, out_of_time, interrupted, unknown } how = How::unknown;
  int number = 0;  // exit status, or the signal
};

/// A running program. Invariant: it is gone when this is; and it goes when the thread that started
/// it ends, whatever ends that thread.
///
/// The program is started afresh (posix_spawn), never forked: a fork of a process with other
/// threads, TBB's or the caller's, would inherit their locks held and not the threads.
class ChildProcess {
 public:
  /// Starts the executable whose bytes are `program`; its standard output is output(). It gets
  /// `arguments` after those that limit_this_process() takes. Throws std::system_error if the
  /// system refuses.
  ChildProcess(std::span<const char> program, const ChildLimits& limits,
               const std::vector<std::string>& arguments);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Ends where the child closes it, and where the child stays silent for too long: five times
  /// limits.cpu_seconds, and ten seconds.
  std::istream& output();

  /// Waits for the child, which is killed if it does not end soon. Call once, after output().
  ChildEnd wait();

 private:
  class Output;
  int pid_ = 0;  // 0: reaped
  std::unique_ptr<Output> output_;
  std::unique_ptr<std::istream> stream_;
};

/// In the child, first of all: limits memory and time, and lets the child die with its parent.
/// Returns the arguments that follow. Throws std::runtime_error where they are not those that
/// ChildProcess gives.
std::vector<std::string> limit_this_process(int argc, char** argv);

}  // namespace isoloop
