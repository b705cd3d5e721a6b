// A child that does as its first argument says; see volume_child_process_test.cpp.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

#include "volume/base/child_process.h"

namespace {

void stay() { std::this_thread::sleep_for(std::chrono::hours(1)); }

int behave(const std::vector<std::string>& arguments) {
  const std::string what = arguments.empty() ? "" : arguments[0];
  if (what == "echo") {
    for (std::size_t i = 1; i < arguments.size(); ++i) std::cout << arguments[i] << '\n';
    return 7;
  }
  if (what == "pid") {
    std::cout << getpid() << std::endl;
    stay();
  }
  if (what == "flood") {
    while (std::cout << std::string(1U << 16, 'x')) {
    }
  }
  if (what == "abort") std::abort();
  if (what == "spin") {
    for (volatile bool on = true; on;) {
    }
  }
  if (what == "allocate") {
    try {
      std::vector<char*> kept;
      kept.reserve(512);
      for (int i = 0; i < 512; ++i) kept.push_back(new char[std::size_t{1} << 20]);
    } catch (const std::bad_alloc&) {
      return 2;
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return behave(isoloop::limit_this_process(argc, argv));
  } catch (const std::exception&) {
    return 1;
  }
}
