// K written out cell by cell from its definition, for small volumes: the oracle of core/. It shares
// no table and no rule with core/cube, only the box that K fills.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/grid/grid.h"
#include "core/grid/lattice.h"

namespace isoloop::oracle {

/// A chain over Z2: the numbers of its cells, ascending.
using Chain = std::vector<int>;

/// Boundaries of K's cells, dimension by dimension. `on_m`, `inside`: where each cell lies; a cell
/// of M is on_m, and neither inside nor outside.
struct ExplicitComplex {
  enum class Place { on_m, inside, outside };

  std::vector<Place> vertices;
  struct Cell {
    Place place;
    Chain boundary;
  };
  std::vector<Cell> edges;   // boundary: vertices
  std::vector<Cell> faces;   // pieces of cube faces and polygons of M; boundary: edges
  std::vector<Cell> solids;  // parts of cubes; boundary: faces
  /// The grid edge that each edge off M is all or half of. Edges off M come before M's.
  std::vector<std::uint32_t> grid_edge_of_edge;
  std::map<int, std::uint32_t> cube_of_wall;  // by face
};

/// For cubes with an interior tunnel, by number: the grid edges on the border of the wall across
/// the torus round it, from one curve of the tube to the other. Any wall will do; this is a choice.
using Walls = std::map<std::uint32_t, std::vector<std::uint32_t>>;

/// `inside_value`: non-negative exactly inside; by voxel of `dims`. `box`: the lattice to fill.
/// Without `walls` no cube has a tunnel; with them the interpolant's tunnels, which must be theirs:
/// throws std::logic_error if they are not, or if a wall does not join a tube's two curves.
ExplicitComplex build_complex(const std::vector<double>& inside_value, const Index3& dims,
                              const Lattice& box, const std::optional<Walls>& walls = {});

}  // namespace isoloop::oracle
