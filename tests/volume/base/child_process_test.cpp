#include "volume/base/child_process.h"

#include <chrono>
#include <csignal>
#include <fstream>
#include <istream>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

using How = ChildEnd::How;
using Words = std::vector<std::string>;

const std::string& program() {
  static const std::string bytes = test::read_bytes(ISOLOOP_CHILD_FOR_TESTS);
  return bytes;
}

ChildLimits small_limits() { return {.memory_bytes = std::uint64_t{64} << 20, .cpu_seconds = 1}; }

std::string all_of(std::istream& in) { return {std::istreambuf_iterator<char>(in), {}}; }

ChildEnd end_of(const Words& arguments) {
  ChildProcess child(program(), small_limits(), arguments);
  all_of(child.output());
  return child.wait();
}

TEST(ChildProcess, GetsItsArgumentsAndGivesItsOutputAndStatus) {
  ChildProcess child(program(), small_limits(), {"echo", "a b", "", "\xff"});
  EXPECT_EQ(all_of(child.output()), "a b\n\n\xff\n");
  const ChildEnd end = child.wait();
  EXPECT_EQ(end.how, How::exited);
  EXPECT_EQ(end.number, 7);
}

TEST(ChildProcess, ACrashIsNotTheParents) {
  const ChildEnd end = end_of({"abort"});
  EXPECT_EQ(end.how, How::crashed);
  EXPECT_EQ(end.number, SIGABRT);
}

TEST(ChildProcess, CannotUseMoreTimeThanItsLimit) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "ten times the time under AddressSanitizer";
#endif
  EXPECT_EQ(end_of({"spin"}).how, How::out_of_time);
}

TEST(ChildProcess, CannotUseMoreMemoryThanItsLimit) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer's own memory goes over any limit";
#endif
  const ChildEnd end = end_of({"allocate"});
  EXPECT_EQ(end.how, How::exited);
  EXPECT_EQ(end.number, 2);
}

TEST(ChildProcess, NeedsNobodyToListen) {
  ChildProcess child(program(), small_limits(), {"flood"});
  EXPECT_EQ(child.output().get(), 'x');
  EXPECT_EQ(child.wait().how, How::exited);
}

TEST(ChildProcess, AnEmptyProgramIsAnError) {
  EXPECT_THROW(ChildProcess(std::span<const char>(), small_limits(), {}), std::system_error);
}

/// Dead, or dead and not yet buried.
bool is_gone(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string number;
  std::string name;
  std::string state;
  return !(file >> number >> name >> state) || state == "Z";
}

bool goes_soon(pid_t pid) {
  for (int i = 0; i < 200 && !is_gone(pid); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return is_gone(pid);
}

pid_t pid_from(std::istream& in) {
  pid_t pid = 0;
  in >> pid;
  return pid;
}

TEST(ChildProcess, GoesWithItsObject) {
  pid_t pid = 0;
  {
    ChildProcess child(program(), small_limits(), {"pid"});
    pid = pid_from(child.output());
    ASSERT_GT(pid, 0);
    EXPECT_FALSE(is_gone(pid));
  }
  EXPECT_TRUE(is_gone(pid));
}

TEST(ChildProcess, GoesWithItsParentWhateverEndsIt) {
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    const test::TempFolder folder;
    const std::filesystem::path report = folder / "pid";
    const pid_t parent = fork();
    ASSERT_GE(parent, 0);
    if (parent == 0) {
      ChildProcess child(program(), small_limits(), {"pid"});
      const pid_t pid = pid_from(child.output());
      std::ofstream(report) << pid << '\n' << std::flush;
      while (true) pause();
    }
    pid_t pid = 0;
    for (int i = 0; i < 1000 && pid == 0; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      std::ifstream file(report);
      std::string line;
      if (std::getline(file, line) && !file.eof()) pid = std::stoi(line);
    }
    ASSERT_GT(pid, 0);
    EXPECT_FALSE(is_gone(pid));
    kill(parent, signal);
    waitpid(parent, nullptr, 0);
    EXPECT_TRUE(goes_soon(pid)) << "signal " << signal;
  }
}

TEST(ChildProcess, WorksBesideOtherThreads) {
  std::vector<std::thread> threads;
  std::vector<int> numbers(8);
  threads.reserve(numbers.size());
  for (int& number : numbers) threads.emplace_back([&number] { number = end_of({"echo"}).number; });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(numbers, std::vector<int>(8, 7));
}

}  // namespace
}  // namespace isoloop
