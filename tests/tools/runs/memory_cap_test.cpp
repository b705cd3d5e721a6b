#include "tools/runs/memory_cap.h"

#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20;

bool can_allocate(std::size_t bytes) {
  try {
    void* const memory = ::operator new(bytes);
    *static_cast<volatile char*>(memory) = 1;
    ::operator delete(memory);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

/// Ends the process with 0 if all is as `memory_cap.h` says. 4 GiB leave room for 400 stacks.
[[noreturn]] void cap_and_exit() {
  if (!can_allocate(4096 * mebibyte)) std::exit(2);  // the machine itself refuses
  cap_memory(512 * mebibyte);
  if (!can_allocate(256 * mebibyte)) std::exit(3);
  std::exit(can_allocate(4096 * mebibyte) ? 4 : 0);
}

// In a process of its own: the bound holds for the rest of a process's life.
TEST(MemoryCap, RefusesWhatGoesOverItAndGrantsTheRest) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer ends the process where memory runs out";
#endif
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(cap_and_exit(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace isoloop
