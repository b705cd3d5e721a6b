// Closed curves along the edges of M.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/surface.h"
#include "isoloop/loop.h"

namespace isoloop {

/// A cycle of edges of M, as vertex pairs, strung into closed curves without repeated vertices.
std::vector<Curve> closed_curves(std::span<const std::array<std::uint32_t, 2>> edges);

/// visit(u, v) for each edge of the closed curve, in its order: the last one leads back to the
/// first vertex.
template <class Visit>
void for_each_edge(const Curve& curve, const Visit& visit) {
  for (std::size_t i = 0; i < curve.size(); ++i)
    visit(curve[i], curve[i + 1 == curve.size() ? 0 : i + 1]);
}

/// Length of closed curves along M's edges, unit of the spacing.
double length_of(const Surface& surface, std::span<const Curve> curves);

}  // namespace isoloop
