#include "volume/base/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <istream>
#include <stdexcept>
#include <streambuf>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace isoloop {
namespace {

// AddressSanitizer's shadow is larger than any limit, and it is slow.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif
#else
constexpr bool sanitized = false;
#endif

constexpr int poll_milliseconds = 100;

[[noreturn]] void fail(const char* what, int error) {
  throw std::system_error(error, std::generic_category(), what);
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close_now(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  void close_now() {
    if (number_ >= 0) close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

/// The program as a file that has no name, so that it needs no place where it is found.
int file_of(std::span<const char> program) {
  const int file = memfd_create("isoloop-child", MFD_CLOEXEC);
  if (file < 0) fail("cannot create a file in memory", errno);
  for (std::size_t done = 0; done < program.size();) {
    const ssize_t bytes = write(file, program.data() + done, program.size() - done);
    if (bytes < 0 && errno == EINTR) continue;
    if (bytes <= 0) {
      const int error = errno;
      close(file);
      fail("cannot write a file in memory", error);
    }
    done += static_cast<std::size_t>(bytes);
  }
  return file;
}

class SpawnSettings {
 public:
  explicit SpawnSettings(int standard_output) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, standard_output, STDOUT_FILENO);
    // A crash prints to standard error; the parent says in one sentence what happened.
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    sigset_t all;
    sigfillset(&all);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  int spawn(pid_t& pid, const std::string& path, std::vector<std::string> words) const {
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    return posix_spawn(&pid, path.c_str(), &actions_, &attributes_, argv.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

std::uint64_t number_of(const char* text) {
  const std::string_view digits(text);
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    throw std::runtime_error("this program is run by isoloop alone");
  }
  return number;
}

void limit(__rlimit_resource resource, std::uint64_t soft, std::uint64_t hard) {
  rlimit bounds{};
  getrlimit(resource, &bounds);
  bounds.rlim_cur = std::min<rlim_t>(soft, bounds.rlim_max);
  bounds.rlim_max = std::min<rlim_t>(hard, bounds.rlim_max);
  setrlimit(resource, &bounds);
}

}  // namespace

/// The child's output as it comes. Silence is counted in turns of poll(), not by the clock, so that
/// a suspended parent does not find its child late.
class ChildProcess::Output : public std::streambuf {
 public:
  Output(int pipe, std::uint64_t most_seconds)
      : pipe_(pipe), most_turns_(most_seconds * (1000 / poll_milliseconds)), buffer_(1U << 18) {}

  bool silent() const { return turns_ >= most_turns_; }
  void close_pipe() { pipe_.close_now(); }

 protected:
  int_type underflow() override {
    while (!silent()) {
      pollfd ready{pipe_.number(), POLLIN, 0};
      const int found = poll(&ready, 1, poll_milliseconds);
      if (found == 0) ++turns_;
      if (found <= 0) continue;
      const ssize_t bytes = read(pipe_.number(), buffer_.data(), buffer_.size());
      if (bytes < 0 && errno == EINTR) continue;
      if (bytes <= 0) return traits_type::eof();
      turns_ = 0;
      setg(buffer_.data(), buffer_.data(), buffer_.data() + bytes);
      return traits_type::to_int_type(*gptr());
    }
    return traits_type::eof();
  }

 private:
  Descriptor pipe_;
  std::uint64_t most_turns_;
  std::uint64_t turns_ = 0;
  std::vector<char> buffer_;
};

ChildProcess::ChildProcess(std::span<const char> program, const ChildLimits& limits,
                           const std::vector<std::string>& arguments) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("cannot create a pipe", errno);
  Descriptor write_end(ends[1]);
  output_ = std::make_unique<Output>(ends[0], 10 + 5 * limits.cpu_seconds);
  stream_ = std::make_unique<std::istream>(output_.get());
  const Descriptor file(file_of(program));
  std::vector<std::string> words{"isoloop-child", std::to_string(getpid()),
                                 std::to_string(limits.memory_bytes),
                                 std::to_string(limits.cpu_seconds)};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const SpawnSettings settings(write_end.number());
  const std::string path = "/proc/self/fd/" + std::to_string(file.number());
  if (const int error = settings.spawn(pid_, path, words)) {
    pid_ = 0;
    fail("cannot start a program", error);
  }
}

ChildProcess::~ChildProcess() {
  if (pid_ == 0) return;
  kill(pid_, SIGKILL);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::istream& ChildProcess::output() { return *stream_; }

ChildEnd ChildProcess::wait() {
  const bool silent = output_->silent();
  if (silent) kill(pid_, SIGKILL);
  output_->close_pipe();  // a child that still writes gets SIGPIPE
  int status = 0;
  pid_t reaped = 0;
  for (int turn = 0; reaped == 0 || (reaped < 0 && errno == EINTR); ++turn) {
    constexpr int most_turns = 2000;  // of five milliseconds
    if (turn == most_turns) kill(pid_, SIGKILL);
    reaped = waitpid(pid_, &status, turn < most_turns ? WNOHANG : 0);
    if (reaped == 0) poll(nullptr, 0, turn < 10 ? 1 : 5);
  }
  pid_ = 0;
  using How = ChildEnd::How;
  if (reaped < 0) return {How::unknown, 0};  // a caller that ignores SIGCHLD learns of no end
  if (silent) return {How::out_of_time, SIGKILL};
  if (WIFEXITED(status)) return {How::exited, WEXITSTATUS(status)};
  const int signal = WTERMSIG(status);
  if (signal == SIGPIPE) return {How::exited, 0};  // nobody listened any longer
  if (signal == SIGXCPU) return {How::out_of_time, signal};
  const bool asked = signal == SIGINT || signal == SIGTERM || signal == SIGHUP;
  return {asked ? How::interrupted : How::crashed, signal};
}

std::vector<std::string> limit_this_process(int argc, char** argv) {
  constexpr int own_arguments = 4;
  if (argc < own_arguments) throw std::runtime_error("this program is run by isoloop alone");
  const std::uint64_t parent = number_of(argv[1]);
  const std::uint64_t memory = number_of(argv[2]);
  const std::uint64_t seconds = number_of(argv[3]);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (static_cast<std::uint64_t>(getppid()) != parent) std::_Exit(1);  // it has gone already
  if (!sanitized) limit(RLIMIT_DATA, memory, memory);
  const std::uint64_t most_seconds = sanitized ? 10 * seconds : seconds;
  limit(RLIMIT_CPU, most_seconds, most_seconds + 1);
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_FSIZE, 0, 0);  // files alone: the pipe is none
  return {argv + own_arguments, argv + argc};
}

}  // namespace isoloop
