// How far the handle or tunnel of a loop extends along M, and how wide it is.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/memory_budget.h"
#include "core/loops/loops.h"
#include "core/surface/surface.h"
#include "isoloop/loop.h"

namespace isoloop {

struct FeatureOptions {
  /// A sweep ends where its front is longer than this times the loop. The front of a tube's loop
  /// keeps its length up to the tube's mouth; from there on, on a flat wall, it grows by 2 pi times
  /// the way: 1.5 ends half a radius beyond the mouth, and leaves a front that zigzags along the
  /// edges of M, or widens a little, alone.
  double ratio = 1.5;
  std::uint64_t max_bytes = unlimited_bytes;  // to hold beside the grid's voxels, M among them
};

/// For each loop, in their order: Dijkstra's search from all vertices of its curves at once, each
/// side until its front is too long or gone (Dey, Li, Sun, Cohen-Steiner, SIGGRAPH 2008, section
/// 6). The surface must be closed, with its graph, and the loops on it. Throws LimitExceeded where
/// searches, or the vertices that they sweep, would take more than options.max_bytes.
std::vector<Feature> features_of(const Surface& surface, const std::vector<Loop>& loops,
                                 const FeatureOptions& options = {});

/// Bytes that M with its graph takes, and the vertices of the features.
std::uint64_t held_bytes(const Surface& surface, const std::vector<Feature>& features);

}  // namespace isoloop
