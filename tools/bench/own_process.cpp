#include "tools/bench/own_process.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace isoloop {
namespace {

constexpr const char* own_path = "/proc/self/exe";

[[noreturn]] void fail(const char* what, int error) {
  throw std::system_error(error, std::generic_category(), what);
}

/// A stream of the child's, in memory, to read once the child has ended.
class CapturedStream {
 public:
  explicit CapturedStream(const char* name) : file_(memfd_create(name, MFD_CLOEXEC)) {
    if (file_ < 0) fail("cannot create a file in memory", errno);
  }
  ~CapturedStream() { close(file_); }
  CapturedStream(const CapturedStream&) = delete;
  CapturedStream& operator=(const CapturedStream&) = delete;

  int number() const { return file_; }

  std::string text() const {
    struct stat status {};
    if (fstat(file_, &status) != 0) return {};
    std::string text(static_cast<std::size_t>(status.st_size), '\0');
    const ssize_t bytes = pread(file_, text.data(), text.size(), 0);
    text.resize(bytes > 0 ? static_cast<std::size_t>(bytes) : 0);
    return text;
  }

 private:
  int file_;
};

pid_t spawned(const std::string& path, const std::vector<std::string>& arguments,
              const CapturedStream& out, const CapturedStream& err) {
  std::vector<std::string> words{path == own_path ? "isoloop" : path};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out.number(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.number(), STDERR_FILENO);
  pid_t child = 0;
  const int error = posix_spawn(&child, path.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail("cannot start a program", error);
  return child;
}

int exit_code_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

ProcessEnd run_captured(const std::string& path, const std::vector<std::string>& arguments,
                        double max_seconds) {
  const CapturedStream out("out");
  const CapturedStream err("err");
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = spawned(path, arguments, out, err);
  ProcessEnd end;
  int status = 0;
  for (int turn = 0;; ++turn) {
    const pid_t reaped = waitpid(child, &status, end.out_of_time ? 0 : WNOHANG);
    if (reaped == child) break;
    if (reaped < 0 && errno != EINTR) fail("cannot wait for a program", errno);
    if (end.out_of_time) continue;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    end.out_of_time = max_seconds > 0.0 && passed.count() >= max_seconds;
    if (end.out_of_time) {
      kill(child, SIGKILL);
    } else {
      poll(nullptr, 0, turn < 20 ? 1 : 10);  // milliseconds
    }
  }
  end.exit_code = exit_code_of(status);
  end.out = out.text();
  end.err = err.text();
  return end;
}

ProcessEnd run_self(const std::vector<std::string>& arguments, double max_seconds) {
  return run_captured(own_path, arguments, max_seconds);
}

void end_with_parent() { prctl(PR_SET_PDEATHSIG, SIGKILL); }

}  // namespace isoloop
