// What each thread of a parallel loop keeps for itself.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <tbb/task_arena.h>

namespace isoloop {

/// At most as many T as threads can be in the task arena at a time. A thread that enters takes over
/// from one that has left, where tbb::enumerable_thread_specific would make one more.
template <class T>
class PerThread {
 public:
  PerThread() : each_(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency())) {}

  /// The calling thread's own, which make() returns if there is none; valid until the thread waits
  /// for a parallel loop. To be called in the arena where this was made.
  template <class Make>
  T& local(const Make& make) {
    std::unique_ptr<T>& own =
        each_[static_cast<std::size_t>(tbb::this_task_arena::current_thread_index())];
    if (!own) own = std::make_unique<T>(make());
    return *own;
  }

  /// Calls visit(T&) for those that were made, in no order that means anything.
  template <class Visit>
  void for_each(const Visit& visit) {
    for (const std::unique_ptr<T>& own : each_)
      if (own) visit(*own);
  }

 private:
  std::vector<std::unique_ptr<T>> each_;
};

}  // namespace isoloop
