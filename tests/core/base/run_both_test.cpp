#include "core/base/run_both.h"

#include <atomic>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

namespace isoloop {
namespace {

TEST(RunBoth, LoopsOfTheOneEndThoughTheOtherThrows) {
  constexpr int count = 200'000;
  for (int round = 0; round < 20; ++round) {
    std::atomic<int> done = 0;
    std::atomic<bool> has_begun = false;
    const auto count_up = [&] {
      tbb::parallel_for(0, count, [&](int) {
        has_begun = true;
        ++done;
      });
    };
    const auto fail = [&] {
      for (int i = 0; i < 1'000'000 && !has_begun; ++i) {
      }
      throw std::runtime_error("no more");
    };
    EXPECT_THROW(run_both(fail, count_up), std::runtime_error);
    EXPECT_EQ(done, count);
    EXPECT_THROW(run_both(count_up, fail), std::runtime_error);
    EXPECT_EQ(done, 2 * count);
  }
}

TEST(RunBoth, TheFirstTasksExceptionComesFirst) {
  const auto fail = [](const char* text) { return [text] { throw std::runtime_error(text); }; };
  try {
    run_both(fail("first"), fail("second"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), std::string("first"));
  }
}

}  // namespace
}  // namespace isoloop
