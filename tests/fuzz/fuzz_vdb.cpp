#include "tests/fuzz/target.h"
#include "volume/vdb/vdb.h"

/// With the child: what OpenVDB does in it must not reach this process.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  return fuzz::expect_answer_or_error(data, size, [](std::string_view bytes) {
    read_vdb(fuzz::file_of(bytes, "a.vdb"), "", {.max_bytes = fuzz::most_bytes});
  });
}
