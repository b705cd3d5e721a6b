// How far the handle or tunnel of a loop extends along M, and how wide it is.
#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include "core/base/memory_budget.h"
#include "core/grid/grid.h"
#include "core/loops/loops.h"
#include "core/surface/surface.h"

namespace isoloop {

struct FeatureOptions {
  /// A sweep ends where its front is longer than this times the loop. The front of a tube's loop
  /// keeps its length up to the tube's mouth; from there on, on a flat wall, it grows by 2 pi times
  /// the way: 1.5 ends half a radius beyond the mouth, and leaves a front that zigzags along the
  /// edges of M, or widens a little, alone.
  double ratio = 1.5;
  std::uint64_t max_bytes = unlimited_bytes;  // to hold beside the grid's voxels, M among them
};

/// What the two fronts sweep that leave a loop to either side at equal speed along M's edges.
/// Lengths are in the unit of the spacing.
struct Feature {
  double area = 0.0;  // swept; unit of the spacing, squared
  /// From one last front to the other. Where these are closer than half the depth, as on a ring,
  /// the normal of the loop. Along the index axes in units of length, of length 1, its largest
  /// component positive: it has no direction. 0 where neither is defined.
  Vec3 axis{};
  /// The way of the fronts' centroids, both sides together: of a tunnel from mouth to mouth (beyond
  /// a mouth fronts widen about one place), of a handle from root to root.
  double depth = 0.0;
  /// The shortest of the loop and the fronts, one each voxel of the way, until the two sides meet:
  /// as on a ring, where fronts are no closed curves from there on.
  double least_girth = 0.0;
  double mean_girth = 0.0;                // of the loop and these fronts
  std::vector<std::uint32_t> vertices{};  // of M, swept; ascending

  /// The diameter of a circle as long as the least girth: how thick a round handle is, how wide a
  /// round tunnel.
  double thickness() const { return least_girth / std::numbers::pi; }
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
