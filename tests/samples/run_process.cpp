#include "tests/samples/run_process.h"

#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/samples/scratch_directory.h"

namespace isoloop {
namespace {

void redirect(int stream, const std::filesystem::path& path, int flags) {
  const int file = open(path.c_str(), flags, 0600);
  if (file < 0 || dup2(file, stream) < 0) _exit(127);
}

}  // namespace

std::filesystem::path isoloop_program() { return ISOLOOP_EXECUTABLE; }

ProcessResult run_isoloop(const std::filesystem::path& directory,
                          const std::vector<std::string>& arguments,
                          const std::filesystem::path& standard_output) {
  return run_program(isoloop_program(), directory, arguments, standard_output);
}

ProcessResult run_program(const std::filesystem::path& program,
                          const std::filesystem::path& directory,
                          const std::vector<std::string>& arguments,
                          const std::filesystem::path& standard_output) {
  const ScratchDirectory streams;
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const std::filesystem::path out =
      standard_output.empty() ? streams.path() / "out" : standard_output;
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) {
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, out, O_WRONLY | O_CREAT);
    redirect(STDERR_FILENO, streams.path() / "err", O_WRONLY | O_CREAT);
    if (chdir(directory.c_str()) != 0) _exit(127);
    execv(argv[0], argv.data());
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ProcessResult result;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = streams.read("out");
  result.err = streams.read("err");
  return result;
}

}  // namespace isoloop
