// The end of a run whose error nothing catches.
#pragma once

namespace isoloop {

/// For std::set_terminate. A lack of memory or of threads, in a library's start or in a thread of
/// its own, ends as it does everywhere else: one sentence, ExitCode::limit_exceeded. All else is a
/// defect, and ends in std::abort. Allocates nothing.
[[noreturn]] void end_uncaught() noexcept;

}  // namespace isoloop
