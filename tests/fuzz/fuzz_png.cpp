#include "tests/fuzz/target.h"
#include "volume/slices/slice_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  return fuzz::expect_answer_or_error(data, size, [](std::string_view bytes) {
    read_slice_volume(fuzz::file_of(bytes, "a.png"), {}, {.max_bytes = fuzz::most_bytes});
  });
}
