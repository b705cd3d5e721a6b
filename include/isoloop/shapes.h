// Solids whose topology is known by construction: for trying isoloop out and for testing it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isoloop/volume.h"

namespace isoloop {

inline constexpr int most_holes = 1000;
inline constexpr int most_cells = 100;

struct ShapeOptions {
  std::int64_t size = 128;      // voxels along the longest axis, at least minimum_shape_size
  int holes = 3;                // plate: holes through it, 0 to most_holes
  int cells = 3;                // lattice: cells along each axis, 1 to most_cells
  std::uint64_t max_bytes = 0;  // of voxels; 0: what the machine can spare
};

/// Betti numbers of the solid: components, independent tunnels, cavities.
struct KnownTopology {
  std::int64_t b0 = 0;
  std::int64_t b1 = 0;
  std::int64_t b2 = 0;

  friend bool operator==(const KnownTopology&, const KnownTopology&) = default;
};

struct Shape {
  Volume volume;                       // float32, spacing 1, like a signed distance in voxels
  std::optional<KnownTopology> known;  // empty where no formula is known (gyroid)
  IsoLevel level{0.0, InsideRule::below};
};

/// ball, engine_block, gyroid, lattice, linked_tori, nested_tori, plate, shell, torus, trefoil.
std::vector<std::string> shape_names();

/// The smallest options.size at which every wall and passage is 3 voxels wide or more.
/// Throws InvalidArgument for an unknown name and for options out of range.
std::int64_t minimum_shape_size(std::string_view name, const ShapeOptions& options = {});

/// Samples a solid. It never comes within two voxels of the volume's border.
/// Throws InvalidArgument (unknown name, options out of range, size below the minimum) and
/// LimitExceeded (more voxels than memory). The same bytes for any number of threads.
Shape make_shape(std::string_view name, const ShapeOptions& options = {});

/// Bounds a shape's distances to 3 voxels on either side of the surface, as level sets are kept in
/// .vdb files: all beyond is two values, which take no room there.
void clip_to_narrow_band(Shape& shape);

}  // namespace isoloop
