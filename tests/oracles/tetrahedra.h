// A complex that is no grid: a box of tetrahedra, some of them inside.
#pragma once

#include <string>
#include <vector>

#include "core/complex/flat_complex.h"
#include "core/surface/surface.h"

namespace isoloop::oracle {

/// M, of one component, as triangles between tetrahedra of the inside and others; and what it
/// leaves of the box on both sides. Edges have the same numbers on both sides.
struct TetrahedralVolume {
  Surface surface;
  FlatComplex inside;
  FlatComplex outside;
};

/// One layer of cubes, cut into six tetrahedra each along a diagonal (Kuhn), with a layer of cubes
/// of the outside about it. `rows`: '#' where a cube is inside; those must meet in whole faces, so
/// that M is a surface, and hang together, so that it has one component.
TetrahedralVolume tetrahedra_of(const std::vector<std::string>& rows);

}  // namespace isoloop::oracle
