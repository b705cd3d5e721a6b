#include "tests/fuzz/header_target.h"
#include "volume/formats/nrrd.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  return fuzz::read_with_header(data, size, {"a.nrrd", "a.nhdr", "\n\n", read_nrrd});
}
