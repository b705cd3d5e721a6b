// The surface as a page shows it: its large pieces, with fewer triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tools/drawings/simplified_mesh.h"
#include "tools/runs/run_result.h"

namespace isoloop {

/// A component of the surface.
struct DrawnPiece {
  std::uint32_t component = 0;  // its place in the surface's
  double area = 0.0;            // of M, in the unit of the spacing, squared
  std::size_t triangles = 0;    // of the drawn mesh
};

struct DrawnSurface {
  TriangleMesh mesh;  // in the frame of the input; triangles piece by piece
  std::vector<std::uint32_t> point_of_vertex;  // of M; `not_drawn` where it is gone
  std::vector<DrawnPiece> pieces;              // the largest area first
  std::size_t pieces_left_out = 0;             // all of them smaller
  double area_left_out = 0.0;                  // of the largest of these
  bool same_topology = true;                   // as the pieces have
};

inline constexpr auto not_drawn = static_cast<std::uint32_t>(-1);

/// The `most_pieces` largest components, or one for every twenty of `most_triangles` if that is
/// less, simplified to `most_triangles`. The topology is kept if that takes no more than twice as
/// many; otherwise small handles go too. `most_pieces` is 1 at
/// least.
DrawnSurface drawn_surface(const LoopsRun& run, std::size_t most_triangles,
                           std::size_t most_pieces);

}  // namespace isoloop
