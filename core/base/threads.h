// How many threads parallel loops run on.
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

/// Runs work() on up to `threads` threads, at least 1, this one among them, and returns its result.
/// Of more threads than the machine has cores all take part: TBB makes them where both the arena
/// and the program allow them.
template <class Work>
auto with_threads(int threads, const Work& work) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  return tbb::task_arena(threads).execute(work);
}

/// The same on as many threads as there are where `threads` is 0.
template <class Work>
auto on_threads(int threads, const Work& work) {
  return with_threads(threads > 0 ? threads : static_cast<int>(thread_count()), work);
}

}  // namespace isoloop
