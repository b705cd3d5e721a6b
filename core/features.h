// How far the handle or tunnel of a loop extends along M, and how wide it is.
#pragma once

#include <cstdint>
#include <vector>

#include "core/grid.h"
#include "core/loops.h"
#include "core/surface.h"

namespace isoloop {

struct FeatureOptions {
  /// A sweep ends where its front is longer than this times the loop. The front of a tube's loop
  /// keeps its length up to the tube's mouth; from there on, on a flat wall, it grows by 2 pi times
  /// the way: 1.5 ends half a radius beyond the mouth, and leaves a front that zigzags along the
  /// edges of M, or widens a little, alone.
  double ratio = 1.5;
};

/// What the two fronts sweep that leave a loop to either side at equal speed along M's edges.
struct Feature {
  double area = 0.0;                    // swept; unit of the spacing, squared
  Vec3 axis{};                          // from one last front to the other; unit vector, see below
  double depth = 0.0;                   // ways of the two fronts together; unit of the spacing
  double least_girth = 0.0;             // of the loop and the fronts, taken each voxel of the way
  double mean_girth = 0.0;              // likewise
  std::vector<std::uint32_t> vertices;  // of M, swept; ascending
};

/// For each loop, in their order: Dijkstra's search from all its vertices at once, each side until
/// its front is too long or gone. The axis is in units of length along the index axes; where both
/// fronts end in one place, it is the normal of the loop. The boundary must be closed.
std::vector<Feature> features_of(const Surface& surface, const std::vector<Loop>& loops,
                                 const FeatureOptions& options = {});

}  // namespace isoloop
