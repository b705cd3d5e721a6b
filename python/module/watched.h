// Work that Python waits for: in a thread of its own, without the interpreter's lock, told of as it
// goes on, and given up where the user interrupts.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include <pybind11/pybind11.h>

#include "isoloop/run.h"

namespace isoloop::python {

/// Runs `work` to its end and throws what it throws. Meanwhile `progress`, unless it is None, is
/// called with a stage and the share done, in the caller's thread. Where that raises, or the user
/// interrupts, the work ends at its next stage and the exception goes to the caller: after a second
/// at most, so the work may still run for a while. `kept` stays alive until it has ended.
void run_watched(const pybind11::object& progress, pybind11::object kept,
                 std::function<void(const Progress&)> work);

/// Waits for all work that was given up.
void end_leftovers();

/// The same, with the result of the work.
template <class Work>
auto watched(const pybind11::object& progress, pybind11::object kept, const Work& work) {
  using Result = std::invoke_result_t<const Work&, const Progress&>;
  const auto result = std::make_shared<std::optional<Result>>();  // the work may outlive the caller
  run_watched(progress, std::move(kept),
              [result, work](const Progress& tell) { result->emplace(work(tell)); });
  return std::move(**result);
}

}  // namespace isoloop::python
