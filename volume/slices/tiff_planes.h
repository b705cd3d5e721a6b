// Which page of a TIFF file is which slice, channel and frame, as the file's description states it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/grid/grid.h"
#include "volume/slices/tiff_file.h"
#include "volume/voxels/placement.h"

namespace isoloop {

enum class TiffAxisName { slices, channels, frames, unnamed };

struct TiffAxis {
  TiffAxisName name = TiffAxisName::slices;
  std::uint64_t size = 1;
};

/// The planes of x and y that a file holds.
struct TiffPlanes {
  std::vector<TiffAxis> axes{};        // that they vary along, the fastest first; none: one plane
  std::vector<std::uint64_t> pages{};  // of each plane; empty: plane n is page n
  bool behind_first = false;           // all follow the first page's pixels, which alone is a page
  std::optional<Vec3> spacing{};       // length per voxel; unset: not stated
  std::string unit{};                  // of the spacing; empty: not stated
  std::vector<Finding> notes{};        // for the volume
  std::vector<Finding> warnings{};     // for the volume
};

/// What a file of so many pages says of them in its first description: OME-XML, ImageJ's text or
/// tifffile's shape; all pages are slices where it is none of these. Throws InvalidInput where the
/// description and the pages contradict each other, where axes have no names to choose by, and as
/// ome_planes does.
TiffPlanes tiff_planes(const std::string& description, std::uint64_t pages, const TiffPage& first,
                       const std::string& what);

/// The page of each slice of the volume that options.frame and options.channel choose. An axis
/// without a name is chosen by either. Frames are slices where there are no slices and no frame is
/// asked for; a note says so. Throws InvalidArgument, which lists the axes with their sizes, where
/// a choice is missing or out of range.
std::vector<std::uint64_t> chosen_pages(TiffPlanes& planes, const FormatOptions& options,
                                        const std::string& what);

}  // namespace isoloop
