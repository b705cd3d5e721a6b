#include "tests/fuzz/target.h"
#include "volume/formats/raw.h"

/// The first byte says how the rest is read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  fuzz::expect_answer_or_error(data, size, [](std::string_view bytes) {
    const unsigned how = bytes.empty() ? 0U : static_cast<unsigned char>(bytes.front());
    const RawOptions options{.dims = Index3{1 + (how & 3U), 2, 2},
                             .type = static_cast<VoxelType>(how >> 2U & 7U),
                             .endian = (how & 32U) != 0 ? Endian::big : Endian::little,
                             .skip = 1};
    read_raw(fuzz::file_of(bytes, "a.raw"), options, {.max_bytes = fuzz::most_bytes});
    RawOptions of_part = options;
    of_part.crop = fuzz::part;
    read_raw(fuzz::file_of(bytes, "a.raw"), of_part, {.max_bytes = fuzz::most_bytes});
  });
  return fuzz::expect_answer_or_error(data, size, [](std::string_view bytes) {
    read_raw(fuzz::file_of(bytes, "a_4x4x1_int16.raw"), {}, {.max_bytes = fuzz::most_bytes});
  });
}
