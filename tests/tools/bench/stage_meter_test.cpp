#include "tools/bench/stage_meter.h"

#include <chrono>
#include <ctime>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

constexpr std::size_t much = std::size_t{64} << 20;  // bytes

/// Keeps a processor at work for so many seconds of its time.
void work(double seconds) {
  const auto spent = [] {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
  const double start = spent();
  while (spent() - start < seconds) {
  }
}

TEST(StageMeter, TellsProcessorTimeFromWallClock) {
  StageMeter meter;
  meter.enter("idle");
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  meter.enter("busy");
  work(0.05);
  const std::vector<StageCost> stages = meter.end();
  ASSERT_EQ(stages.size(), 2U);
  EXPECT_EQ(stages[0].name, "idle");
  EXPECT_GE(stages[0].wall_seconds, 0.05);
  EXPECT_LT(stages[0].cpu_seconds, 0.025);
  EXPECT_GE(stages[1].cpu_seconds, 0.05);
}

TEST(StageMeter, CountsThreadsThatHaveEnded) {
  StageMeter meter;
  meter.enter("other");
  std::thread([] { work(0.05); }).join();
  EXPECT_GE(meter.end().at(0).cpu_seconds, 0.05);
}

TEST(StageMeter, GoesOnWithAStageOfTheSameName) {
  StageMeter meter;
  for (const char* stage : {"surface", "surface", "loops", "loops"}) meter.enter(stage);
  EXPECT_EQ(meter.end().size(), 2U);
  EXPECT_TRUE(meter.end().empty());
}

TEST(StageMeter, GivesAStageThePeakWithinItAlone) {
  StageMeter meter;
  meter.enter("large");
  {
    const std::vector<char> bytes(much, 1);
    EXPECT_EQ(bytes.back(), 1);
  }
  meter.enter("small");
  const std::vector<StageCost> stages = meter.end();
  EXPECT_GE(stages[0].peak_bytes, much);
  EXPECT_LT(stages[1].peak_bytes, stages[0].peak_bytes - much / 2);
}

TEST(StageMeter, TheWholeIsTheSumOfTimesAndTheLargestPeak) {
  const StageCost whole = whole_of({{"read", 1.0, 2.0, 30}, {"loops", 4.0, 8.0, 20}});
  EXPECT_EQ(whole.name, "all");
  EXPECT_EQ(whole.cpu_seconds, 5.0);
  EXPECT_EQ(whole.wall_seconds, 10.0);
  EXPECT_EQ(whole.peak_bytes, 30U);
}

}  // namespace
}  // namespace isoloop
