#include "tests/fuzz/target.h"
#include "volume/slices/tiff.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  const auto read = [&](const FormatOptions& options) {
    return fuzz::expect_answer_or_error(data, size, [&](std::string_view bytes) {
      read_tiff(fuzz::file_of(bytes, "a.tif"), options, {.max_bytes = fuzz::most_bytes});
    });
  };
  read({.frame = 0, .channel = 0});
  return read({.channel = 0});
}
