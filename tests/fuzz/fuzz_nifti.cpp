#include <algorithm>

#include "tests/fuzz/target.h"
#include "volume/formats/nifti.h"

/// As one file, by the qform too, and as a pair: a header of NIfTI-1, and what follows.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  constexpr VoxelLimits limits{.max_bytes = fuzz::most_bytes};
  fuzz::expect_answer_or_error(data, size, [&](std::string_view bytes) {
    read_nifti(fuzz::file_of(bytes, "a.nii"), {.frame = 0}, limits);
    read_nifti(fuzz::file_of(bytes, "a.nii"), {.frame = 0, .transform = NiftiTransform::qform},
               limits);
    read_nifti(fuzz::file_of(bytes, "a.nii"), {.frame = 0, .crop = fuzz::part}, limits);
  });
  return fuzz::expect_answer_or_error(data, size, [&](std::string_view bytes) {
    const std::size_t header = std::min<std::size_t>(348, bytes.size());
    fuzz::file_of(bytes.substr(header), "p.img");
    read_nifti(fuzz::file_of(bytes.substr(0, header), "p.hdr"), {.frame = 0}, limits);
  });
}
