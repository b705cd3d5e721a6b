#include "tools/words/uncaught.h"

#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "tools/words/exit_code.h"

namespace isoloop {
namespace {

[[noreturn]] void end(std::string_view sentence) {
  for (const std::string_view part : {std::string_view("isoloop: "), sentence, {"\n"}})
    if (write(STDERR_FILENO, part.data(), part.size()) < 0) break;
  _exit(static_cast<int>(ExitCode::limit_exceeded));
}

}  // namespace

void end_uncaught() noexcept {
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    end(memory_sentence);
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again) end(memory_sentence);
  } catch (...) {
  }
  std::abort();
}

}  // namespace isoloop
