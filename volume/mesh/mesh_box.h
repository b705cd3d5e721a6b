// Upright boxes round meshes and triangles.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "volume/mesh/mesh.h"

namespace isoloop {

/// From `low` to `high`, both in it; without a point as it is made.
struct Box {
  Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  Vec3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
            -std::numeric_limits<double>::infinity()};
};

/// The least box that holds both.
inline Box joined(Box box, const Box& other) {
  for (std::size_t a = 0; a < 3; ++a) {
    box.low[a] = std::min(box.low[a], other.low[a]);
    box.high[a] = std::max(box.high[a], other.high[a]);
  }
  return box;
}

inline Box box_of(const Mesh& mesh, std::size_t triangle) {
  Box box;
  for (const std::uint32_t corner : mesh.triangles[triangle]) {
    box = joined(box, Box{mesh.points[corner], mesh.points[corner]});
  }
  return box;
}

/// Of all triangles; points that are in none do not count.
inline Box box_of(const Mesh& mesh) {
  Box box;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) box = joined(box, box_of(mesh, t));
  return box;
}

inline double diagonal(const Box& box) {
  return std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]);
}

/// Whether they have a point in common.
inline bool meet(const Box& a, const Box& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.high[axis] < b.low[axis] || b.high[axis] < a.low[axis]) return false;
  }
  return true;
}

}  // namespace isoloop
