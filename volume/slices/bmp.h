// BMP files as slices: the uncompressed ones of Windows and OS/2.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "volume/slices/slice_image.h"

namespace isoloop {

/// What the header states: pixels of 8 bits with a palette, or of 24 bits, as uint8. Throws
/// InvalidInput: no BMP file, other sorts of pixels, compression, a palette that is not grey, and
/// a file that is shorter than its pixels take.
SliceImage bmp_image(const std::filesystem::path& path);

/// Decodes the file into `to`, which has the size of bmp_image(); the first row is the topmost,
/// whichever the file begins with. Throws InvalidInput as bmp_image() does, for colour, and for
/// pixels that the palette does not hold.
void read_bmp(const std::filesystem::path& path, std::span<std::byte> to);

}  // namespace isoloop
