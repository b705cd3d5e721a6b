// Tunnels for the table of core/cube: where a cut may have one, and what the cut becomes with it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/cube/cube.h"

namespace isoloop {

/// A closed curve in which M cuts the cube's surface: the cut cube edges that it crosses, in the
/// direction of its patch's border.
using Polygon = std::vector<int>;

/// The tube runs along a diagonal of the cube, from the hub's cell to a cell of the same side at
/// the opposite corner or, where that one is cut off alone, at its three neighbours; both cells
/// border on one cell of the other side. No face joins the two corners on which the diagonal is
/// cast. These conditions are those of all cuts that have tunnels (a test draws each). One hub for
/// each such diagonal: that on the shorter curve, else on the first.
InplaceVector<std::uint8_t, 2> tunnel_hubs(std::uint8_t inside, std::uint8_t joined,
                                           const std::vector<Polygon>& polygons,
                                           const CubeCut& cut);

/// `plain` with the two discs on the curves at `hub`, one of its hubs, replaced by a tube.
TunnelCut drill_tunnel(std::uint8_t inside, const std::vector<Polygon>& polygons,
                       const CubeCut& plain, int hub);

}  // namespace isoloop
