#include "core/curves/triangle_fans.h"

#include <numeric>

#include "core/base/errors.h"

namespace isoloop {

TriangleFans::TriangleFans(const Surface& surface)
    : surface_(surface),
      first_(surface.points.size() + 1),
      triangles_(3 * surface.triangles.size()) {
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t vertex : triangle) ++first_[vertex];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  for (auto t = static_cast<std::uint32_t>(surface.triangles.size()); t-- > 0;)
    for (const std::uint32_t vertex : surface.triangles[t]) triangles_[--first_[vertex]] = t;
}

std::uint32_t TriangleFans::apex(std::uint32_t from, std::uint32_t to) const {
  for (std::uint32_t i = first_[from]; i < first_[from + 1]; ++i) {
    const auto& corners = surface_.triangles[triangles_[i]];
    for (std::size_t k = 0; k < 3; ++k)
      if (corners[k] == from && corners[(k + 1) % 3] == to) return corners[(k + 2) % 3];
  }
  throw SelfCheckFailed("a loop takes a step that is no edge of the surface");
}

}  // namespace isoloop
