// Closed curves along the edges of M.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/surface.h"
#include "isoloop/loop.h"

namespace isoloop {

/// A cycle of edges of M, as vertex pairs, strung into closed curves without repeated vertices.
std::vector<Curve> closed_curves(std::span<const std::array<std::uint32_t, 2>> edges);

/// Length of closed curves along M's edges, unit of the spacing.
double length_of(const Surface& surface, std::span<const Curve> curves);

}  // namespace isoloop
