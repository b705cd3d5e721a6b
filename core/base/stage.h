// Stages of the work, so that what goes wrong in one is told with its name.
#pragma once

#include <array>
#include <cstddef>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/base/errors.h"

namespace isoloop {

/// Whether an allocation failed, or the stack of one more thread found no memory, for which TBB has
/// no type of its own.
inline bool lacks_memory(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
         dynamic_cast<const std::length_error*>(&error) != nullptr ||
         std::string_view(error.what()).find("pthread_create") != std::string_view::npos;
}

inline constexpr std::size_t spare_bytes = std::size_t{1} << 15;

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
  // Given back where memory ends, so that there is some for the words that say so.
  auto spare = std::make_unique<std::array<char, spare_bytes>>();
  try {
    return work();
  } catch (const std::exception& error) {
    if (!lacks_memory(error)) throw;
    spare.reset();
    throw fail();
  }
}

}  // namespace isoloop
