#include "tools/words/exit_code.h"

#include <exception>
#include <system_error>

#include <nlohmann/json.hpp>

#include "core/base/errors.h"
#include "core/base/stage.h"
#include "tools/words/json_text.h"
#include "tools/words/sentence.h"

namespace isoloop {
Failure failure_of(const std::exception_ptr& error, std::string_view command) {
  try {
    std::rethrow_exception(error);
  } catch (const InvalidArgument& e) {
    return {ExitCode::usage, sentence_of(e.finding, command, e.option)};
  } catch (const InvalidInput& e) {
    return {ExitCode::invalid_input, sentence_of(e.finding, command)};
  } catch (const LimitExceeded& e) {
    return {ExitCode::limit_exceeded, sentence_of(e.finding, command)};
  } catch (const SelfCheckFailed& e) {
    return {ExitCode::self_check_failed, "self-check failed, no result: " + one_line(e.what())};
  } catch (const std::system_error& e) {  // threads, or files: a full disk, a vanished file
    if (e.code() == std::errc::resource_unavailable_try_again)
      return {ExitCode::limit_exceeded, memory_sentence};
    return {ExitCode::invalid_input, one_line(e.what())};
  } catch (const std::exception& e) {
    if (lacks_memory(e)) return {ExitCode::limit_exceeded, memory_sentence};
    return {ExitCode::self_check_failed, "unexpected error: " + one_line(e.what())};
  } catch (...) {
    return {ExitCode::self_check_failed, "unexpected error"};
  }
}

std::string error_event(const Failure& failure) {
  return line_of({{"event", "error"},
                  {"code", static_cast<int>(failure.code)},
                  {"message", failure.sentence}});
}

}  // namespace isoloop
