// A four-cylinder engine block: the passages of a real casting, counted by hand.
#pragma once

#include <cstdint>

#include "volume/shapes/shapes.h"

namespace isoloop {

/// Extent along the crankshaft, in voxels, from which on every wall and passage is 3 voxels wide.
inline constexpr double least_engine_block_extent = 96.0;

/// The block with its longest side `extent` voxels long. Throws LimitExceeded for more bytes of
/// voxels than that (0: than the machine can spare).
Shape make_engine_block(double extent, std::uint64_t max_bytes = 0);

}  // namespace isoloop
