#include "tests/fuzz/split.h"
#include "tests/fuzz/target.h"
#include "volume/meta_image.h"

/// As one file, and as a header with the data file a.raw.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  constexpr VoxelLimits limits{.max_bytes = fuzz::most_bytes};
  fuzz::expect_answer_or_error(data, size, [&](std::string_view bytes) {
    read_meta_image(fuzz::file_of(bytes, "a.mha"), {.frame = 0}, limits);
  });
  return fuzz::expect_answer_or_error(data, size, [&](std::string_view bytes) {
    const auto [header, voxels] = fuzz::split_after(bytes, "= a.raw\n");
    fuzz::file_of(voxels, "a.raw");
    read_meta_image(fuzz::file_of(header, "a.mhd"), {.frame = 0}, limits);
  });
}
