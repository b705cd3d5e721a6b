// The errors that isoloop throws. A caller needs no others.
#pragma once

#include <stdexcept>
#include <string>

namespace isoloop {

/// An argument that makes no sense for the data at hand (usage; exit code 2).
struct InvalidArgument : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Data that cannot be read or must not be trusted: missing file, wrong size, NaN (exit code 3).
struct InvalidInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// More memory, voxels or indices than allowed; thrown before they are asked for (exit code 4).
struct LimitExceeded : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A result that contradicts another one: never print it as an answer (exit code 5).
struct SelfCheckFailed : std::logic_error {
  using std::logic_error::logic_error;
};

}  // namespace isoloop
