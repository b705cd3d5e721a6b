// How long work is watched, and how much memory it may take.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

namespace isoloop {

/// Told at the start of each stage, and now and then within it. May be called from any thread.
using Progress = std::function<void(const char* stage, double share_done)>;

/// For options that bound memory.
inline constexpr std::uint64_t unlimited_bytes = std::numeric_limits<std::uint64_t>::max();

}  // namespace isoloop
