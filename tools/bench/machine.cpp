#include "tools/bench/machine.h"

#include <fstream>

#include <sys/utsname.h>
#include <unistd.h>

#include "core/base/threads.h"
#include "tools/words/number_text.h"

namespace isoloop {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return {};
}

std::string system_name() {
  utsname name{};
  if (uname(&name) != 0) return {};
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

std::string compiler_name() {
#ifdef __clang__
  return "clang++ " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace

Machine this_machine() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page = sysconf(_SC_PAGESIZE);
  return {.processor = processor_name(),
          .cores = static_cast<int>(thread_count()),
          .memory_bytes = pages > 0 && page > 0
                              ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page)
                              : 0,
          .system = system_name(),
          .compiler = compiler_name(),
          .version = ISOLOOP_VERSION};
}

std::string machine_text(const Machine& machine) {
  constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
  return (machine.processor.empty() ? "unknown processor" : machine.processor) + ", " +
         counted(machine.cores, "core", "cores") + ", " +
         fixed_text(static_cast<double>(machine.memory_bytes) / gibibyte, 1) + " GiB; " +
         machine.system + "; isoloop " + machine.version + ", " + machine.compiler;
}

}  // namespace isoloop
