// OME-XML: what an OME-TIFF says of its pages.
#pragma once

#include <cstdint>
#include <string>

#include "volume/slices/tiff_planes.h"

namespace isoloop {

/// Whether a TIFF file's description is OME-XML.
bool is_ome(const std::string& description);

/// The planes that the description states: DimensionOrder with SizeZ, SizeC and SizeT, and the
/// TiffData elements. Spacing in the unit of the x axis. Throws InvalidInput: damaged XML, several
/// images, planes in other files, interleaved samples, planes without a page, more than one plane
/// on a page.
TiffPlanes ome_planes(const std::string& description, std::uint64_t pages, const SliceImage& image,
                      const std::string& what);

}  // namespace isoloop
