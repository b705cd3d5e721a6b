#include <csignal>

#include "tools/command_line.h"

int main(int argc, char** argv) {
  // A file that grows too large is an error like a full disk, not the end of the process.
  std::signal(SIGXFSZ, SIG_IGN);
  return isoloop::run_command_line({argv + (argc > 0 ? 1 : 0), argv + argc});
}
