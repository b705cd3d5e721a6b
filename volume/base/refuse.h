// How readers refuse a file.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/errors.h"

namespace isoloop {

/// Throws InvalidInput of `file`: a path, and perhaps the part of it that is meant.
[[noreturn]] inline void refuse(const std::string& file, std::string complaint,
                                Fault fault = Fault::damaged, std::vector<Advice> advice = {}) {
  throw InvalidInput({.file = file, .text = std::move(complaint), .advice = std::move(advice)},
                     fault);
}

}  // namespace isoloop
