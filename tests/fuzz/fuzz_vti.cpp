#include "tests/fuzz/target.h"
#include "volume/formats/vti.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  fuzz::expect_answer_or_error(data, size, [](std::string_view bytes) {
    read_vti(fuzz::file_of(bytes, "a.vti"), {}, {.max_bytes = fuzz::most_bytes});
  });
  return fuzz::expect_answer_or_error(data, size, [](std::string_view bytes) {
    read_vti(fuzz::file_of(bytes, "a.vti"), {.array = "cells:v"}, {.max_bytes = fuzz::most_bytes});
  });
}
