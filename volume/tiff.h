// TIFF: pages of one file, or the files of a folder, as slices.
#pragma once

#include <filesystem>

#include "volume/memory_limit.h"
#include "volume/placement.h"
#include "volume/volume.h"

namespace isoloop {

/// Reads the pages of a file, or the first page of each .tif or .tiff file of a folder, ordered by
/// name (numbers in names by their value), as slices from z = 0 on; x runs along the rows. One
/// value per pixel of 8, 16 or 32 bits, integer or float, in any of libtiff's lossless
/// compressions. The frame is `index`, with spacing 1 unless options.spacing says otherwise.
/// Throws LimitExceeded, and InvalidInput: a file or one of its pages that is cut short or damaged,
/// pages that differ in size or type, fewer pages than its ImageJ description states, colour,
/// several samples per pixel, packed bits, JPEG.
Volume read_tiff(const std::filesystem::path& path, const FormatOptions& options = {},
                 const VoxelLimits& limits = {});

/// Whether a file of the folder is named .tif or .tiff.
bool holds_tiff(const std::filesystem::path& folder);

}  // namespace isoloop
