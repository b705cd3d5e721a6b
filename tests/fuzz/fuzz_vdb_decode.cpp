#include <sstream>

#include "tests/fuzz/target.h"
#include "volume/vdb/vdb_decode.h"
#include "volume/vdb/vdb_message.h"

/// What the child does, in this process: finds the defects of OpenVDB that the child is there for.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  return fuzz::expect_answer_or_error(data, size, [](std::string_view bytes) {
    std::istringstream in{std::string(bytes)};
    std::stringstream message;
    try {
      decode_vdb(in, {}, "a.vdb", message);
      receive_volume(message, {.max_bytes = fuzz::most_bytes}, "a.vdb");
    } catch (const std::bad_alloc&) {
    }
  });
}
