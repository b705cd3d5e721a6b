// The box of grid vertices that K fills, and how its vertices, edges, faces and cubes are numbered.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/grid/grid.h"

namespace isoloop {

/// The two closed parts that M divides the box into: inside is I, outside is O.
enum class Side : std::uint8_t { outside = 0, inside = 1 };

constexpr Side other(Side side) { return side == Side::inside ? Side::outside : Side::inside; }

/// The indices of a voxel that is numbered in scan order.
constexpr Index3 voxel_index(std::size_t voxel, const Index3& dims) {
  const auto at = static_cast<std::int64_t>(voxel);
  return {at % dims[0], at / dims[0] % dims[1], at / dims[0] / dims[1]};
}

/// A box of dims[0] * dims[1] * dims[2] grid vertices; vertex (0, 0, 0) of it is voxel `first` of
/// the grid, which may lie one step outside it. Numbers are 32-bit:
///   vertex v = x + dims[0] * (y + dims[1] * z)
///   edge   3 v + a: from v along axis a
///   face   3 v + a: v its lowest corner, a its normal
///   cube   v: v its lowest corner
struct Lattice {
  std::array<std::uint32_t, 3> dims{};
  std::array<std::uint32_t, 3> stride{};  // of vertices
  Index3 first{};

  std::uint32_t vertex_count() const { return dims[0] * dims[1] * dims[2]; }

  std::array<std::uint32_t, 3> position(std::uint32_t vertex) const {
    const std::uint32_t row = vertex / dims[0];
    return {vertex - row * dims[0], row % dims[1], row / dims[1]};
  }

  std::uint32_t vertex(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    return x + dims[0] * (y + dims[1] * z);
  }

  /// The voxel at a vertex, by its indices in the grid; it may lie outside it.
  Index3 voxel_at(std::uint32_t vertex) const {
    const auto p = position(vertex);
    return {first[0] + p[0], first[1] + p[1], first[2] + p[2]};
  }

  /// The vertex at that voxel; nothing where the box ends before it.
  std::optional<std::uint32_t> vertex_at(const Index3& voxel) const {
    std::array<std::uint32_t, 3> p{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int64_t at = voxel[a] - first[a];
      if (at < 0 || at >= std::int64_t{dims[a]}) return std::nullopt;
      p[a] = static_cast<std::uint32_t>(at);
    }
    return vertex(p[0], p[1], p[2]);
  }

  /// Corner 0 to 7 of the cube with lowest corner `cube`; bit a: beyond it along axis a.
  std::uint32_t corner(std::uint32_t cube, unsigned corner) const {
    return cube + (corner & 1U) * stride[0] + (corner >> 1 & 1U) * stride[1] +
           (corner >> 2 & 1U) * stride[2];
  }
};

/// Largest vertex count for which edge and face numbers fit 32 bits, with room for second pieces.
inline constexpr std::uint64_t max_lattice_vertices = 1'300'000'000;

/// Largest voxel index, along an axis, beside which points of M in single precision lie clear of
/// the voxels.
inline constexpr std::int64_t max_voxel_index = (std::int64_t{1} << 20) - 1;

inline Lattice make_lattice(const Index3& first, const std::array<std::uint32_t, 3>& dims) {
  return {dims, {1, dims[0], dims[0] * dims[1]}, first};
}

/// The two axes across `axis`, in cyclic order.
constexpr std::array<int, 2> cross_axes(int axis) { return {(axis + 1) % 3, (axis + 2) % 3}; }

/// Number of the lattice edge that is edge `cube_edge` (see core/cube/cube.h) of the cube at
/// `vertex`.
inline std::uint32_t lattice_edge(const Lattice& lattice, std::uint32_t vertex, int cube_edge) {
  const auto axis = static_cast<std::uint32_t>(cube_edge / 4);
  const auto [b, c] = cross_axes(cube_edge / 4);
  const std::uint32_t base =
      vertex + (cube_edge & 1) * lattice.stride[b] + (cube_edge >> 1 & 1) * lattice.stride[c];
  return 3 * base + axis;
}

}  // namespace isoloop
