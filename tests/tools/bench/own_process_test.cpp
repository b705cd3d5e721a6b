#include "tools/bench/own_process.h"

#include <chrono>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

ProcessEnd shell(const std::string& script, double max_seconds = 0.0) {
  return run_captured("/bin/sh", {"-c", script}, max_seconds);
}

TEST(OwnProcess, GivesWhatItWroteAndHowItEnded) {
  const ProcessEnd end = shell("echo out; echo err >&2; exit 3");
  EXPECT_EQ(end.exit_code, 3);
  EXPECT_EQ(end.out, "out\n");
  EXPECT_EQ(end.err, "err\n");
  EXPECT_FALSE(end.out_of_time);
}

TEST(OwnProcess, TellsASignalFromAnExitCode) {
  const ProcessEnd end = shell("kill -9 $$");
  EXPECT_EQ(end.exit_code, 128 + 9);
  EXPECT_FALSE(end.out_of_time);
}

TEST(OwnProcess, IsEndedWhereItTakesTooLong) {
  const auto start = std::chrono::steady_clock::now();
  const ProcessEnd end = shell("exec sleep 60", 0.1);
  EXPECT_TRUE(end.out_of_time);
  EXPECT_EQ(end.exit_code, 128 + 9);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(OwnProcess, WaitsForNothingOnStandardInput) { EXPECT_EQ(shell("cat; echo end").out, "end\n"); }

}  // namespace
}  // namespace isoloop
