#include "tests/fuzz/split.h"
#include "tests/fuzz/target.h"
#include "volume/nrrd.h"

/// As one file, and as a header with the data file a.raw.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  constexpr VoxelLimits limits{.max_bytes = fuzz::most_bytes};
  fuzz::expect_answer_or_error(data, size, [&](std::string_view bytes) {
    read_nrrd(fuzz::file_of(bytes, "a.nrrd"), {.frame = 0}, limits);
  });
  return fuzz::expect_answer_or_error(data, size, [&](std::string_view bytes) {
    const auto [header, voxels] = fuzz::split_after(bytes, "\n\n");
    fuzz::file_of(voxels, "a.raw");
    read_nrrd(fuzz::file_of(header, "a.nhdr"), {.frame = 0}, limits);
  });
}
