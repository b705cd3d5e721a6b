// How many threads a parallel loop runs on.
#pragma once

#include <algorithm>
#include <cstddef>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace isoloop {

/// At least 1: the task arena's threads, of which tbb::global_control may allow fewer.
inline std::size_t thread_count() {
  return std::min(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()),
                  tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace isoloop
