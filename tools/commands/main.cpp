#include <csignal>
#include <exception>

#include "tools/commands/command_line.h"
#include "tools/words/uncaught.h"

namespace {

void set_terminate_first() { std::set_terminate(isoloop::end_uncaught); }

// Called before the start of the libraries, one of which makes threads then.
[[gnu::section(".preinit_array"), gnu::used]] void (*const first_call)() = set_terminate_first;

}  // namespace

int main(int argc, char** argv) {
  // A file that grows too large is an error like a full disk, not the end of the process.
  std::signal(SIGXFSZ, SIG_IGN);
  return isoloop::run_command_line({argv + (argc > 0 ? 1 : 0), argv + argc});
}
