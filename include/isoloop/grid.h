// Voxel grids as spans of numbers, and where the solid in them ends: all that the topology asks.
//
// In all headers of this folder: I is the solid, the inside of the iso-surface; M is the surface; O
// is the rest, which reaches beyond the grid. Lengths are in the unit of GridView::spacing. Points
// are in voxel indices, (0, 0, 0) the centre of the first voxel, unless they are called world.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

namespace isoloop {

using Index3 = std::array<std::int64_t, 3>;  // (i, j, k); i is the fastest axis in memory
using Vec3 = std::array<double, 3>;

inline double distance(const Vec3& p, const Vec3& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// The spacings that isoloop takes, in any unit of length. Lengths along M are kept in single
/// precision and volumes in double: both have room for more steps than a grid has.
inline constexpr double least_spacing = 1e-18;
inline constexpr double most_spacing = 1e18;

/// Whether it lies between them; not if it is NaN.
constexpr bool is_spacing(double length) {
  return length >= least_spacing && length <= most_spacing;
}

/// A scalar field on dims[0] * dims[1] * dims[2] voxel centres. Not owned.
template <class T>
struct GridView {
  std::span<const T> values;    // values[i + dims[0] * (j + dims[1] * k)]
  Index3 dims{};                // each at least 1
  Vec3 spacing{1.0, 1.0, 1.0};  // unit of length per voxel, each is_spacing()
};

/// A grid in the type that its voxels were stored in.
using AnyGridView =
    std::variant<GridView<std::uint8_t>, GridView<std::int8_t>, GridView<std::uint16_t>,
                 GridView<std::int16_t>, GridView<std::uint32_t>, GridView<std::int32_t>,
                 GridView<float>, GridView<double>>;

/// Which voxels belong to I, the solid: those with f >= iso, or those with f <= iso.
enum class InsideRule { above, below };

/// How M runs within the cubes between voxels. trilinear: it has the topology of the trilinear
/// interpolant's iso-surface. simple: a cube's parts are those of its surface, and all are balls.
/// Both cut the cubes' faces as the bilinear interpolant does. The others are for masks and go by
/// which voxels are inside alone: inside voxels are joined across cube faces (connected_6), edges
/// too (connected_18), or corners too (connected_26), and outside ones by the adjacency that goes
/// with it: 26, 6 and 6 (Kong and Rosenfeld, Digital topology, CVGIP 1989).
enum class Topology { trilinear, simple, connected_6, connected_18, connected_26 };

/// Where the solid's border runs. f = iso is inside under both rules.
struct IsoLevel {
  double iso = 0.0;  // unit of the voxel values
  InsideRule inside = InsideRule::above;
  Topology topology = Topology::trilinear;
  /// With InsideRule::above alone: inside are the values from iso to this one, itself included, and
  /// what is interpolated is how far a value lies within them. Unit of the voxel values.
  std::optional<double> upper{};
};

/// What lies beyond the grid. closed: the outside, so that M is closed. open: nothing; M may end at
/// the border of the grid, and its sides are not told apart (Dey, Li, Sun, Cohen-Steiner, SIGGRAPH
/// 2008, last section).
enum class Boundary { closed, open };

}  // namespace isoloop
