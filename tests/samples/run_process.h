// Runs the built isoloop, or another program, as a user would.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isoloop {

struct ProcessResult {
  int exit_code = -1;  // 128 + signal where the process was killed
  std::string out;     // standard output
  std::string err;     // standard error
};

/// Runs `program` in `directory`, as run_isoloop() runs isoloop.
ProcessResult run_program(const std::filesystem::path& program,
                          const std::filesystem::path& directory,
                          const std::vector<std::string>& arguments,
                          const std::filesystem::path& standard_output = {});

std::filesystem::path isoloop_program();

/// Runs isoloop in `directory` with `arguments`, without standard input. Standard output goes to
/// `standard_output`, or to the result if that is empty.
ProcessResult run_isoloop(const std::filesystem::path& directory,
                          const std::vector<std::string>& arguments,
                          const std::filesystem::path& standard_output = {});

}  // namespace isoloop
