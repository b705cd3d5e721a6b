// Stages of the work, so that what goes wrong in one is told with its name.
#pragma once

#include <new>
#include <stdexcept>
#include <string>

#include "core/base/errors.h"

namespace isoloop {

/// Returns work(). Throws LimitExceeded, naming the stage, where an allocation fails.
template <class Work>
auto in_stage(const char* stage, const Work& work) -> decltype(work()) {
  const auto fail = [&]() -> LimitExceeded {
    return LimitExceeded(
        Finding{.text = std::string("the stage '") + stage +
                        "' asks for more memory than there is, or than the limit allows",
                .advice = {Advice::take_part, Advice::halve_resolution}},
        Excess{.stage = stage});
  };
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw fail();
  } catch (const std::length_error&) {
    throw fail();
  }
}

}  // namespace isoloop
