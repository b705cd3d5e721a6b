// What a TIFF file's description says of its pages, as ImageJ and tifffile write it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "volume/slices/tiff_file.h"
#include "volume/slices/tiff_planes.h"

namespace isoloop {

/// "1 page", "2 pages".
inline std::string count_text(std::uint64_t count, const char* one, const char* more) {
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

/// Of a description that begins with "ImageJ=". Throws as tiff_planes() does.
TiffPlanes imagej_planes(const std::string& description, std::uint64_t pages, const TiffPage& first,
                         const std::string& what);

/// Whether it is what tifffile writes of an array of several dimensions.
bool states_shape(std::string_view description);

/// Of such a description. Throws as tiff_planes() does.
TiffPlanes shaped_planes(std::string_view description, std::uint64_t pages, const TiffPage& first,
                         const std::string& what);

}  // namespace isoloop
