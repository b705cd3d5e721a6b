// Where the surfaces that the labels span across handles and tunnels meet M.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/complex/near_surface.h"
#include "core/engines/dual_pass.h"
#include "core/loops/certificate.h"
#include "core/surface/surface.h"
#include "core/z2/z2_basis.h"

namespace isoloop {

/// For every generator i: the edges of M, as vertex pairs, on the border of the surface made of the
/// pieces whose label contains i. Round each vertex of M their number is even.
struct KillingBorders {
  std::vector<std::size_t> first;  // of each generator, and the end
  std::vector<std::array<std::uint32_t, 2>> edges;

  std::span<const std::array<std::uint32_t, 2>> of(std::uint32_t generator) const {
    return {edges.data() + first[generator], first[generator + 1] - first[generator]};
  }
};

/// Compiled in killing_border.cpp for the complexes that are listed there.
template <MeetsSurface C>
KillingBorders killing_borders(const C& complex, const DualPass& pass);

/// The classes of the borders in the homology of the other side; vector i is border i, and they
/// span all that bounds on this side. Coordinate i of a class in this basis says whether it closes
/// handle (or tunnel) i. Throws SelfCheckFailed where the borders are not a basis.
Z2Basis border_classes(const Surface& surface, const SurfaceClasses& classes, Side side,
                       const KillingBorders& borders);

}  // namespace isoloop
