#include <sstream>

#include "tests/fuzz/target.h"
#include "volume/vdb/vdb_message.h"

/// What a child that has been led astray might send.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  return fuzz::expect_answer_or_error(data, size, [](std::string_view bytes) {
    std::istringstream in{std::string(bytes)};
    try {
      receive_volume(in, {.max_bytes = fuzz::most_bytes}, "a.vdb");
    } catch (const BrokenMessage&) {
    }
  });
}
