// Whether a mesh bounds a solid.
#pragma once

#include <cstddef>

#include "volume/mesh/mesh.h"

namespace isoloop {

struct Closure {
  std::size_t open_edges = 0;     // that an odd number of triangles have
  std::size_t one_way_edges = 0;  // that triangles run along more often one way than the other
};

/// Counts the edges that keep the mesh from being a cycle: with integers (one way and the other
/// cancel) and modulo 2. A cycle of integers has a winding number about each point; one modulo 2
/// has an inside by even and odd.
Closure closure_of(const Mesh& mesh);

}  // namespace isoloop
