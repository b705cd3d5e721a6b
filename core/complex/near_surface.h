// What is asked of a complex beside M: segments on borders, pieces round cut edges, voxels.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <vector>

#include "core/complex/complex.h"

namespace isoloop {

inline constexpr auto no_piece = static_cast<std::uint32_t>(-1);

/// What is there of M on the borders of pieces: what the borders of the surfaces that labels span
/// ask.
template <class C>
concept MeetsSurface = requires(const C& complex, std::uint32_t piece) {
  /// The segments of M on the piece's border, as pairs of vertices of M.
  { complex.segments(piece) } -> ListOf<std::array<std::uint32_t, 2>>;
};

/// What PAIR asks.
template <class C>
concept PairComplex = Complex<C> && MeetsSurface<C>;

/// The four pieces round the half of a cut edge on this side, in cyclic order, or no_piece, and the
/// lowest corners of the cubes between them: cube i lies between pieces i and i + 1. A wall that
/// ends at the edge within cube i parts it further.
struct CutRing {
  std::array<std::uint32_t, 4> pieces;
  std::array<std::uint32_t, 4> cubes;
  std::array<std::uint32_t, 4> walls;  // or no_piece
};

/// Where a triangle of M meets a wall at one of its vertices from beyond it: after the wall in the
/// order of the cut ring, or in one of the two sectors at a vertex within the cube.
struct BeyondWall {
  std::uint32_t piece;     // the wall
  std::uint32_t cube;      // by lowest corner
  std::uint32_t triangle;  // among the cube's own, in their order in M
  std::uint32_t corner;    // of the triangle: 0, 1 or 2
};

/// How a walk on M passes the pieces beside it: what the classes of such walks ask.
template <class C>
concept BesideSurface = Complex<C> && requires(const C& complex, std::uint32_t edge) {
  { complex.cut_ring(edge) } -> std::same_as<CutRing>;
  { complex.beyond_walls() } -> std::same_as<std::vector<BeyondWall>>;
};

/// Where a piece lies in the grid.
template <class C>
concept HasCorners = requires(const C& complex, std::uint32_t piece) {
  /// The grid vertices at the piece's corners.
  { complex.corners(piece) } -> ListOf<std::uint32_t>;
};

/// Where voxels, grid vertices on this side, lie among cells and pieces: what membranes ask.
template <class C>
concept HoldsVoxels = HasCorners<C> &&
    requires(const C& complex, std::uint32_t number, std::uint32_t corner) {
  complex.side();
  { complex.cell_bound() } -> std::convertible_to<std::uint32_t>;
  /// The piece of the grid's face, and the cell of its cube, at one of their corners.
  { complex.piece_at(number, corner) } -> std::same_as<std::uint32_t>;
  { complex.cell_at(number, corner) } -> std::same_as<std::uint32_t>;
};

}  // namespace isoloop
