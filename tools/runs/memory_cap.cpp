#include "tools/runs/memory_cap.h"

#include <algorithm>
#include <array>
#include <fstream>

#include <sys/resource.h>
#include <unistd.h>

#include "core/base/threads.h"

namespace isoloop {
namespace {

/// The data of this process now, as RLIMIT_DATA counts it; 0 where the system does not tell.
rlim_t held_data() {
  std::ifstream file("/proc/self/statm");
  std::array<rlim_t, 6> pages{};
  for (rlim_t& number : pages) file >> number;
  return file ? pages[5] * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace

void cap_memory(std::uint64_t bytes) {
  constexpr rlim_t usual_stack = rlim_t{8} << 20;
  rlimit stack{};
  rlimit data{};
  if (getrlimit(RLIMIT_STACK, &stack) != 0 || getrlimit(RLIMIT_DATA, &data) != 0) return;
  const rlim_t one_stack = stack.rlim_cur == RLIM_INFINITY ? usual_stack : stack.rlim_cur;
  const rlim_t all_stacks = one_stack * thread_count();
  // Below what is held already there would be no room to find out, and say, what needs how much.
  constexpr rlim_t room = rlim_t{1} << 20;
  data.rlim_cur = std::min<rlim_t>(data.rlim_max, std::max(bytes + all_stacks, held_data() + room));
  setrlimit(RLIMIT_DATA, &data);
}

}  // namespace isoloop
