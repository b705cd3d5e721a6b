// The errors that isoloop throws, with what happened as data. A caller needs no others; tools/ maps
// each to an exit code and says in its own words what to do.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "isoloop/finding.h"

namespace isoloop {

/// what() is text_of(finding).
struct Error : std::runtime_error {
  explicit Error(Finding found) : std::runtime_error(text_of(found)), finding(std::move(found)) {}
  explicit Error(const std::string& text) : Error(Finding{.text = text}) {}
  Finding finding;
};

/// An argument that makes no sense for the data at hand (usage; exit code 2).
struct InvalidArgument : Error {
  explicit InvalidArgument(const std::string& text) : Error(text) {}
  explicit InvalidArgument(const Finding& found, Option which = Option::none)
      : Error(found), option(which == Option::none ? found.about : which) {}
  Option option = Option::none;  // which one; none where there is no option for it
};

/// What is wrong with an input.
enum class Fault {
  damaged,      // cut short, or it contradicts itself
  unreadable,   // not there, or the system does not let it be read
  unsupported,  // perhaps whole, but of a kind that isoloop does not read
  not_finite,   // NaN among its voxels
  unwritable,   // of a file that was to be written
};

inline constexpr Fault last_fault = Fault::unwritable;

/// Data that cannot be read or must not be trusted: missing file, wrong size, NaN (exit code 3).
struct InvalidInput : Error {
  explicit InvalidInput(const std::string& text) : Error(text) {}
  explicit InvalidInput(const Finding& found, Fault what_is_wrong = Fault::damaged)
      : Error(found), fault(what_is_wrong) {}
  Fault fault = Fault::damaged;
};

/// By how much a limit is passed; both figures are 0 where they are not known.
struct Excess {
  enum class Unit { none, bytes, voxels };
  Unit unit = Unit::none;
  std::uint64_t needed = 0;
  std::uint64_t limit = 0;
  std::string stage{};  // of the work; empty where it is none of them
};

/// More memory, voxels or indices than allowed; thrown before they are asked for (exit code 4).
struct LimitExceeded : Error {
  explicit LimitExceeded(const std::string& text) : Error(text) {}
  explicit LimitExceeded(const Finding& found, Excess by = {})
      : Error(found), excess(std::move(by)) {}
  Excess excess{};
};

/// A result that contradicts another one: never print it as an answer (exit code 5).
struct SelfCheckFailed : std::logic_error {
  using std::logic_error::logic_error;
};

}  // namespace isoloop
