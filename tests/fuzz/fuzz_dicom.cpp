#include <algorithm>
#include <vector>

#include "tests/fuzz/target.h"
#include "volume/formats/dicom.h"

namespace {

/// The files that lie one after the other in the bytes: each begins 128 bytes before a "DICM".
std::vector<std::string_view> slices_of(std::string_view bytes) {
  std::vector<std::string_view> slices;
  std::size_t from = 0;
  for (std::size_t at = bytes.find("DICM", 132); at != std::string_view::npos && slices.size() < 4;
       at = bytes.find("DICM", at + 4)) {
    const std::size_t next = std::max(from, at - 128);
    slices.push_back(bytes.substr(from, next - from));
    from = next;
  }
  slices.push_back(bytes.substr(from));
  return slices;
}

}  // namespace

/// As one slice, or as the slices of a folder where there are several.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isoloop;
  return fuzz::expect_answer_or_error(data, size, [](std::string_view bytes) {
    constexpr VoxelLimits limits{.max_bytes = fuzz::most_bytes};
    const std::vector<std::string_view> slices = slices_of(bytes);
    if (slices.size() == 1) {
      read_dicom(fuzz::file_of(bytes, "a.dcm"), {.frame = 0}, limits);
      return;
    }
    const std::filesystem::path folder = fuzz::empty_folder("series");
    for (std::size_t i = 0; i < slices.size(); ++i) {
      fuzz::file_of(slices[i], "series/" + std::to_string(i));
    }
    read_dicom(folder, {.frame = 0}, limits);
  });
}
