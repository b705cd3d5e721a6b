#include "core/base/threads.h"

#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

namespace isoloop {
namespace {

TEST(Threads, AreCountedByWhatBothTheArenaAndTheProgramAllow) {
  EXPECT_EQ(tbb::task_arena(1).execute(thread_count), 1U);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(thread_count(), 1U);
}

TEST(Threads, AllTakePartEvenWhereThereAreFewerCores) {
  constexpr int threads = 16;
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  std::atomic<int> started = 0;
  with_threads(threads, [&] {
    EXPECT_EQ(thread_count(), std::size_t{threads});
    tbb::parallel_for(
        0, threads,
        [&](int) {
          ++started;  // and wait for the others, so that no thread takes two turns
          while (started < threads && std::chrono::steady_clock::now() < give_up)
            std::this_thread::yield();
        },
        tbb::simple_partitioner());
    EXPECT_LT(std::chrono::steady_clock::now(), give_up);
  });
}

TEST(Threads, ReturnWhatTheWorkReturnsAndThrowWhatItThrows) {
  EXPECT_EQ(with_threads(3, [] { return 7; }), 7);
  EXPECT_THROW(with_threads(3, []() -> int { throw 7; }), int);
}

}  // namespace
}  // namespace isoloop
