#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "core/thread_count.h"

namespace isoloop {
namespace {

TEST(ThreadCount, IsWhatBothTheArenaAndTheProgramAllow) {
  EXPECT_EQ(tbb::task_arena(1).execute(thread_count), 1U);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(thread_count(), 1U);
}

}  // namespace
}  // namespace isoloop
