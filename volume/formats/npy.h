// NumPy arrays (numpy.org/doc/stable/reference/generated/numpy.lib.format.html).
#pragma once

#include <filesystem>
#include <iosfwd>

#include "volume/base/memory_limit.h"
#include "volume/voxels/placement.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// Reads an array[z, y, x] of numbers or bools from a .npy file; of two axes it is one layer, of
/// four the first counts frames. An array of bools is a mask. Both orders in memory (C and Fortran)
/// give the same volume. The frame is `index`, with spacing 1 unless options.spacing says
/// otherwise. Throws InvalidArgument (several frames, and options.frame does not choose),
/// LimitExceeded, and InvalidInput: bytes that are missing or too many, a header that makes no
/// sense, complex numbers, records, objects and texts.
Volume read_npy(const std::filesystem::path& path, const FormatOptions& options = {},
                const VoxelLimits& limits = {});

/// Writes an array[z, y, x], little-endian, in C order; a mask of 0 and 1 as bools. The format says
/// nothing of where voxels lie. A failure shows in the stream's state.
void write_npy(std::ostream& out, const Volume& volume);

}  // namespace isoloop
