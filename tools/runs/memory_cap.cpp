#include "tools/runs/memory_cap.h"

#include <algorithm>

#include <sys/resource.h>

#include "core/base/threads.h"

namespace isoloop {

void cap_memory(std::uint64_t bytes) {
  constexpr rlim_t usual_stack = rlim_t{8} << 20;
  rlimit stack{};
  rlimit data{};
  if (getrlimit(RLIMIT_STACK, &stack) != 0 || getrlimit(RLIMIT_DATA, &data) != 0) return;
  const rlim_t one_stack = stack.rlim_cur == RLIM_INFINITY ? usual_stack : stack.rlim_cur;
  const rlim_t all_stacks = one_stack * thread_count();
  data.rlim_cur = std::min<rlim_t>(data.rlim_max, bytes + all_stacks);
  setrlimit(RLIMIT_DATA, &data);
}

}  // namespace isoloop
