// The machine and the build that figures were measured on.
#pragma once

#include <cstdint>
#include <string>

namespace isoloop {

struct Machine {
  std::string processor{};         // "AMD EPYC"; empty: the system does not say
  int cores = 0;                   // that this process may use
  std::uint64_t memory_bytes = 0;  // of the machine
  std::string system{};            // "Linux 6.1.0 x86_64"
  std::string compiler{};          // "g++ 12.2.0"
  std::string version{};           // of isoloop
};

Machine this_machine();

/// "AMD EPYC, 2 cores, 8.0 GiB; Linux 6.1.0 x86_64; isoloop 0.1.0, g++ 12.2.0".
std::string machine_text(const Machine& machine);

}  // namespace isoloop
