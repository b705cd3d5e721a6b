// TIFF: the pages of a file as slices.
#pragma once

#include <filesystem>

#include "volume/base/memory_limit.h"
#include "volume/slices/slice_image.h"
#include "volume/voxels/placement.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// Reads the pages of a file as slices from z = 0 on; x runs along the rows. One value per pixel of
/// 8, 16 or 32 bits, or a float, in any of libtiff's lossless compressions. Slices within one page
/// (ImageDepth; behind ImageJ's one page) are read too. Where the description states channels or
/// frames, options.channel and options.frame choose: see tiff_planes() and chosen_pages(). The
/// frame is `index`, with the spacing that OME-XML or ImageJ's description states, else 1, unless
/// options.spacing says otherwise.
/// Throws LimitExceeded, InvalidArgument as chosen_pages() does, and InvalidInput: a file or one of
/// its pages that is cut short or damaged, pages that differ in size or type, colour, several
/// samples per pixel, packed bits, JPEG, and as tiff_planes() does.
Volume read_tiff(const std::filesystem::path& path, const FormatOptions& options = {},
                 const VoxelLimits& limits = {});

/// The one slice that a file holds, for folders of them. Throws InvalidInput as read_tiff() does,
/// and for more than one page.
SliceImage tiff_slice_image(const std::filesystem::path& path);

/// Decodes it into `to`, which has its size. Throws as read_tiff() does.
void read_tiff_slice(const std::filesystem::path& path, const VoxelLimits& limits,
                     std::span<std::byte> to);

}  // namespace isoloop
