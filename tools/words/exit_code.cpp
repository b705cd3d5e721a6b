#include "tools/words/exit_code.h"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <system_error>

#include <nlohmann/json.hpp>

#include "core/base/errors.h"

namespace isoloop {
namespace {

std::string one_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

// TBB knows no type of its own for this: the stack of one more thread finds no memory.
bool no_room_for_a_thread(const std::exception& error) {
  return std::string(error.what()).find("pthread_create") != std::string::npos;
}

}  // namespace

Failure failure_of(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const InvalidArgument& e) {
    return {ExitCode::usage, one_line(e.what())};
  } catch (const InvalidInput& e) {
    return {ExitCode::invalid_input, one_line(e.what())};
  } catch (const LimitExceeded& e) {
    return {ExitCode::limit_exceeded, one_line(e.what())};
  } catch (const std::bad_alloc&) {
    return {ExitCode::limit_exceeded, memory_sentence};
  } catch (const std::length_error&) {
    return {ExitCode::limit_exceeded, memory_sentence};
  } catch (const SelfCheckFailed& e) {
    return {ExitCode::self_check_failed, "self-check failed, no result: " + one_line(e.what())};
  } catch (const std::system_error& e) {  // threads, or files: a full disk, a vanished file
    if (e.code() == std::errc::resource_unavailable_try_again)
      return {ExitCode::limit_exceeded, memory_sentence};
    return {ExitCode::invalid_input, one_line(e.what())};
  } catch (const std::exception& e) {
    if (no_room_for_a_thread(e)) return {ExitCode::limit_exceeded, memory_sentence};
    return {ExitCode::self_check_failed, "unexpected error: " + one_line(e.what())};
  } catch (...) {
    return {ExitCode::self_check_failed, "unexpected error"};
  }
}

std::string error_event(const Failure& failure) {
  const nlohmann::ordered_json event = {
      {"event", "error"}, {"code", static_cast<int>(failure.code)}, {"message", failure.sentence}};
  return event.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace isoloop
