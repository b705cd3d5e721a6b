// A folder of slices, one TIFF, PNG or BMP file each.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "volume/base/memory_limit.h"
#include "volume/voxels/placement.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// Reads the files of the folder (not of folders within it) as slices from z = 0 on, in the order
/// of name_less(). A folder of one TIFF file is that file: see read_tiff(). One warning names the
/// kinds of files that are not read; others as odd_names() says. The frame is `index`; the spacing
/// is options.spacing, else what the scanner's log beside the slices states, see
/// read_slice_logs(), else 1.
/// Throws LimitExceeded, InvalidArgument (options.frame or options.channel other than 0), and
/// InvalidInput: slices of several formats, slices that differ in size or type from the first,
/// names as odd_names() refuses them, and what the formats' readers refuse.
Volume read_slice_folder(const std::filesystem::path& folder, const FormatOptions& options = {},
                         const VoxelLimits& limits = {});

/// Whether a file of the folder is a TIFF, PNG or BMP file by its name.
bool holds_slices(const std::filesystem::path& folder);

/// "2 .txt files, Thumbs.db and 1 folder": what a folder holds, for messages; at most eight kinds.
std::string folder_contents(const std::filesystem::path& folder);

}  // namespace isoloop
