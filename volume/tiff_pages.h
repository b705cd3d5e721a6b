// The directories of a TIFF file (TIFF 6.0, BigTIFF): every byte that they point to is there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace isoloop {

struct TiffPages {
  std::vector<std::uint64_t> at;  // byte of each page's directory
  std::string description;        // what programs write of the first page, at most 64 KiB
};

/// The pages in order. Throws InvalidInput if the file cannot be read, is no TIFF file, or if a
/// directory, a value or a strip or tile of pixels reaches beyond its end, if directories run in a
/// circle or share what they list, and for more than a million pages.
TiffPages read_tiff_pages(const std::filesystem::path& path);

}  // namespace isoloop
