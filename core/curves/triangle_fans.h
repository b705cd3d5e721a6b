// The triangles round each vertex of M, for walks from triangle to triangle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/surface.h"

namespace isoloop {

/// Refers to the surface, which must be closed and outlive it.
class TriangleFans {
 public:
  explicit TriangleFans(const Surface& surface);

  /// The third corner of the triangle that runs along the directed edge, that is, lies to its left
  /// as seen from where M's triangles turn anticlockwise. Throws SelfCheckFailed where M has no
  /// such edge.
  std::uint32_t apex(std::uint32_t from, std::uint32_t to) const;

  /// The numbers of the triangles round a vertex, ascending.
  std::span<const std::uint32_t> triangles(std::uint32_t vertex) const {
    return {triangles_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }

 private:
  const Surface& surface_;
  std::vector<std::uint32_t> first_;  // in triangles_: of each vertex, and the end
  std::vector<std::uint32_t> triangles_;
};

}  // namespace isoloop
