// The one place that gives exit codes their meaning.
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace isoloop {

enum class ExitCode {
  done = 0,
  usage = 2,              // the command line makes no sense, by itself or for this input
  invalid_input = 3,      // a file that cannot be read, must not be trusted or cannot be written
  limit_exceeded = 4,     // more memory or voxels than allowed or there is, or a full disk
  self_check_failed = 5,  // a result that contradicts another one, or a defect of isoloop
};

/// Of a run that finds no memory.
inline constexpr const char* memory_sentence =
    "this takes more memory than there is, or than the limit allows; take a smaller volume";

/// How a run that threw ends.
struct Failure {
  ExitCode code = ExitCode::self_check_failed;
  std::string sentence;  // one line without "isoloop: " and without a full stop
};

/// The end of a run of `command` (count, repair, ...) that threw `error`, which must not be null.
Failure failure_of(const std::exception_ptr& error, std::string_view command = {});

/// The same as one JSON object: "event" ("error"), "code", "message".
std::string error_event(const Failure& failure);

}  // namespace isoloop
