#include "core/base/per_thread.h"

#include <optional>
#include <thread>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace isoloop {
namespace {

TEST(PerThread, HoldsNoMoreThanTheArenaHasThreadsWhoeverComesAndGoes) {
  constexpr int visitors = 20;
  constexpr int turns = 1000;
  tbb::task_arena arena(2);
  std::optional<PerThread<int>> counters;
  arena.execute([&] { counters.emplace(); });
  for (int i = 0; i < visitors; ++i)
    std::thread([&] {
      arena.execute(
          [&] { tbb::parallel_for(0, turns, [&](int) { ++counters->local([] { return 0; }); }); });
    }).join();
  int made = 0;
  int sum = 0;
  counters->for_each([&](int counter) {
    ++made;
    sum += counter;
  });
  EXPECT_LE(made, 2);
  EXPECT_EQ(sum, visitors * turns);
}

}  // namespace
}  // namespace isoloop
