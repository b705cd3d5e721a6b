// Writes a file anew with some of its voxels replaced.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <span>

#include "volume/voxels/volume.h"

namespace isoloop {

/// Copies the file that `volume` was read from, whose stored_at must be set, but for the voxels
/// listed (in scan order, ascending): these get the values that the volume has. Header, other
/// voxels and other frames keep their bytes; what was packed is packed again. Throws InvalidInput
/// if the file is no longer as long as it was. A failure to write shows in the stream's state.
void write_patched(const Volume& volume, std::span<const std::size_t> voxels, std::ostream& out);

}  // namespace isoloop
