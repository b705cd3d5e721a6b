// The pieces that kill, by the slow reduction: what both engines are compared with.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "core/complex/flat_complex.h"
#include "core/grid/lattice.h"
#include "tests/oracles/explicit_complex.h"
#include "tests/samples/core_fixture.h"

namespace isoloop::testing {

struct SidedPiece {
  Side side = Side::inside;
  std::uint32_t piece = 0;
  auto operator<=>(const SidedPiece&) const = default;
};

/// One side of a complex that is written out, for the engines. `pieces`: what its pieces are in
/// core/, by whose sizes and in whose order they stand.
struct WrittenSide {
  FlatComplex complex;
  FlatSizes sizes;
  std::vector<SidedPiece> pieces;
};

/// Throws std::logic_error where the pieces of core/ are not those of `slow`.
WrittenSide written_side(const Prepared& prepared, const oracle::ExplicitComplex& slow, Side side);

/// After M the pieces of `sides` enter in one filtration, by (size, number). Those that kill a
/// class of M, in that order. Throws std::logic_error where the pieces of core/ are not those of
/// `slow`.
std::vector<SidedPiece> slow_killing_pieces(const Prepared& prepared,
                                            const oracle::ExplicitComplex& slow,
                                            std::span<const Side> sides);

}  // namespace isoloop::testing
