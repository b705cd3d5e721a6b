// Formats whose header stands before the voxels or in a file of its own.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "tests/fuzz/target.h"
#include "volume/base/memory_limit.h"
#include "volume/voxels/placement.h"
#include "volume/voxels/volume.h"

namespace isoloop::fuzz {

struct HeaderFormat {
  std::string whole;     // name of a file that holds all
  std::string header;    // name of one that names a.raw as its data file
  std::string_view end;  // of such a header
  Volume (*read)(const std::filesystem::path&, const FormatOptions&, const VoxelLimits&);
};

/// The bytes as one file, whole and a part of it; and as two, parted after the first `end`, or all
/// header without it.
inline int read_with_header(const std::uint8_t* data, std::size_t size,
                            const HeaderFormat& format) {
  constexpr VoxelLimits limits{.max_bytes = most_bytes};
  expect_answer_or_error(data, size, [&](std::string_view bytes) {
    format.read(file_of(bytes, format.whole), {.frame = 0}, limits);
  });
  expect_answer_or_error(data, size, [&](std::string_view bytes) {
    format.read(file_of(bytes, format.whole), {.frame = 0, .crop = part}, limits);
  });
  return expect_answer_or_error(data, size, [&](std::string_view bytes) {
    const std::size_t found = bytes.find(format.end);
    const std::size_t header =
        found == std::string_view::npos ? bytes.size() : found + format.end.size();
    file_of(bytes.substr(header), "a.raw");
    format.read(file_of(bytes.substr(0, header), format.header), {.frame = 0}, limits);
  });
}

}  // namespace isoloop::fuzz
