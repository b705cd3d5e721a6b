#include "volume/base/atomic_file.h"

#include <array>
#include <csignal>
#include <string>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/errors.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

using test::contains;
using test::message_of;
using test::read_bytes;
using test::TempFolder;
using test::write_bytes;

TEST(AtomicFile, AppearsWholeOnCommit) {
  const TempFolder folder;
  AtomicFile file(folder / "out.json");
  file.stream() << "whole";
  EXPECT_FALSE(std::filesystem::exists(folder / "out.json"));
  file.commit();
  EXPECT_EQ(read_bytes(folder / "out.json"), "whole");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(AtomicFile, LeavesNothingWithoutCommit) {
  const TempFolder folder;
  {
    AtomicFile file(folder / "out.json");
    file.stream() << "half";
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(AtomicFile, KeepsTheOldFileUntilCommit) {
  const TempFolder folder;
  write_bytes(folder / "out.json", "old");
  {
    AtomicFile file(folder / "out.json");
    file.stream() << "half" << std::flush;
    EXPECT_EQ(read_bytes(folder / "out.json"), "old");
  }
  EXPECT_EQ(read_bytes(folder / "out.json"), "old");
  AtomicFile file(folder / "out.json");
  file.stream() << "new";
  file.commit();
  EXPECT_EQ(read_bytes(folder / "out.json"), "new");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(AtomicFile, RefusesAFolderADeviceAndAMissingFolderByName) {
  const TempFolder folder;
  for (const auto& target :
       {folder.path(), std::filesystem::path("/dev/null"), folder / "none/out.json"}) {
    const std::string message = message_of<InvalidInput>([&] { AtomicFile file(target); });
    EXPECT_TRUE(contains(message, target.string())) << message;
  }
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_EQ(folder.entries(), 0);
}

TEST(AtomicFile, WritesThroughASymbolicLink) {
  const TempFolder folder;
  write_bytes(folder / "real.json", "old");
  std::filesystem::create_symlink(folder / "real.json", folder / "link.json");
  AtomicFile file(folder / "link.json");
  file.stream() << "new";
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.json"));
  EXPECT_EQ(read_bytes(folder / "real.json"), "new");
}

/// Stands for a full disk: no file may grow past `bytes` while this lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit limit{bytes, old_limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_limit_{};
  void (*old_handler_)(int);
};

TEST(AtomicFile, AFailedWriteIsAnErrorAndLeavesNothing) {
  const TempFolder folder;
  for (const std::size_t size : {std::size_t{2000}, std::size_t{200000}}) {
    const FileSizeLimit full(1000);
    const std::string message = message_of<LimitExceeded>([&] {
      AtomicFile file(folder / "out.raw");
      file.stream() << std::string(size, 'x');
      file.commit();
    });
    EXPECT_TRUE(contains(message, "out.raw: cannot be written")) << message;
  }
  EXPECT_EQ(folder.entries(), 0);
}

/// Writes half a file over `target`, says so on `pipe`, and waits for its end.
[[noreturn]] void write_half_and_wait(const std::filesystem::path& target, int pipe) {
  AtomicFile file(target);
  file.stream() << std::string(100000, 'x') << std::flush;
  if (write(pipe, "x", 1) != 1) _exit(1);
  while (true) pause();
}

TEST(AtomicFile, NoSignalLeavesAPartOfAFile) {
  const TempFolder folder;
  write_bytes(folder / "old", "old");
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    for (const char* name : {"new", "old"}) {
      std::array<int, 2> ends{};
      ASSERT_EQ(pipe(ends.data()), 0);
      const pid_t child = fork();
      ASSERT_GE(child, 0);
      if (child == 0) write_half_and_wait(folder / name, ends[1]);
      char byte = 0;
      ASSERT_EQ(read(ends[0], &byte, 1), 1);
      kill(child, signal);
      waitpid(child, nullptr, 0);
      close(ends[0]);
      close(ends[1]);
      EXPECT_EQ(folder.entries(), 1) << "signal " << signal;
      EXPECT_EQ(read_bytes(folder / "old"), "old");
    }
  }
}

TEST(AtomicFile, HasThePermissionsThatAnyNewFileHas) {
  const TempFolder folder;
  write_bytes(folder / "usual", "x");
  AtomicFile file(folder / "out");
  file.commit();
  EXPECT_EQ(std::filesystem::status(folder / "out").permissions(),
            std::filesystem::status(folder / "usual").permissions());
}

}  // namespace
}  // namespace isoloop
