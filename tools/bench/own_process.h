// This program once more, in a process of its own.
#pragma once

#include <string>
#include <vector>

namespace isoloop {

struct ProcessEnd {
  int exit_code = 0;         // 128 + signal where one ended it
  bool out_of_time = false;  // ended by us, by a signal
  std::string out{};         // standard output
  std::string err{};         // standard error
};

/// Starts the executable that runs now with `arguments` and waits for its end, at most
/// `max_seconds` of wall clock (0: as long as it takes). Not forked: what runs there has neither
/// the memory of this process nor its peak. Throws std::system_error if the system refuses.
ProcessEnd run_self(const std::vector<std::string>& arguments, double max_seconds);

/// The same of another program.
ProcessEnd run_captured(const std::string& path, const std::vector<std::string>& arguments,
                        double max_seconds);

/// In such a process, first of all: it ends when the one that started it does.
void end_with_parent();

}  // namespace isoloop
