// A bound on the memory of the whole process.
#pragma once

#include <cstdint>

namespace isoloop {

/// From now on an allocation that would bring the process's data over `bytes` throws
/// std::bad_alloc. The stacks of as many threads as may run here (thread_count()) come on top,
/// since TBB ends the process where it cannot start one; and it may always take a mebibyte more
/// than it holds now, which is what errors are told with. Where the system knows no such bound,
/// nothing happens.
void cap_memory(std::uint64_t bytes);

}  // namespace isoloop
