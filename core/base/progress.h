// How long work tells how far it has come.
#pragma once

#include <functional>

namespace isoloop {

/// Told at the start of each stage, and now and then within it. May be called from any thread.
using Progress = std::function<void(const char* stage, double share_done)>;

}  // namespace isoloop
