// The directories of a TIFF file (TIFF 6.0, BigTIFF): every byte that they point to is there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "volume/base/byte_order.h"

namespace isoloop {

struct TiffPages {
  std::vector<std::uint64_t> at;  // byte of each page's directory
  std::string description;        // what programs write of the first page, at most 64 MiB
  Endian endian = Endian::little;
  std::uint64_t pixels_at = 0;    // byte of the first page's first strip or tile
  std::uint64_t pixel_bytes = 0;  // of its strips or tiles, if they follow each other; else 0
  std::uint64_t file_bytes = 0;
};

/// The pages in order. Throws InvalidInput if the file cannot be read, is no TIFF file, or if a
/// directory, a value or a strip or tile of pixels reaches beyond its end, if directories run in a
/// circle or share what they list, and for more than a million pages or a longer description.
TiffPages read_tiff_pages(const std::filesystem::path& path);

}  // namespace isoloop
