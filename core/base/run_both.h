// Two tasks at once, each of which may use all threads.
#pragma once

#include <array>
#include <exception>

#include <tbb/parallel_invoke.h>

namespace isoloop {

/// Runs both to their ends, and then throws what `first` threw, or else `second`. If one throws out
/// of tbb::parallel_invoke, the loops that run within the other are cancelled: they return with
/// their work half done, and the other goes on with that.
template <class First, class Second>
void run_both(const First& first, const Second& second) {
  std::array<std::exception_ptr, 2> thrown;
  const auto kept = [](const auto& task, std::exception_ptr& place) {
    return [&] {
      try {
        task();
      } catch (...) {
        place = std::current_exception();
      }
    };
  };
  tbb::parallel_invoke(kept(first, thrown[0]), kept(second, thrown[1]));
  for (const std::exception_ptr& each : thrown)
    if (each) std::rethrow_exception(each);
}

}  // namespace isoloop
