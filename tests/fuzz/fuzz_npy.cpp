#include "tests/fuzz/target.h"
#include "volume/formats/npy.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  fuzz::expect_answer_or_error(data, size, [](std::string_view bytes) {
    read_npy(fuzz::file_of(bytes, "a.npy"), {.frame = 0, .crop = fuzz::part},
             {.max_bytes = fuzz::most_bytes});
  });
  return fuzz::expect_answer_or_error(data, size, [](std::string_view bytes) {
    read_npy(fuzz::file_of(bytes, "a.npy"), {.frame = 0}, {.max_bytes = fuzz::most_bytes});
  });
}
