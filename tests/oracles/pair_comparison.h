// The two engines against each other on one volume.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/engines/dual_pass.h"
#include "core/engines/pair.h"
#include "tests/samples/core_fixture.h"

namespace isoloop::testing {

inline std::vector<std::uint32_t> killing_pieces(const std::vector<SurfacePair>& pairs, Side side) {
  std::vector<std::uint32_t> pieces;
  for (const SurfacePair& pair : pairs)
    if (pair.side == side) pieces.push_back(pair.piece);
  return pieces;
}

inline std::vector<std::uint32_t> killing_pieces(const DualPass& pass) {
  std::vector<std::uint32_t> pieces;
  for (const KillingPiece& killing : pass.killing) pieces.push_back(killing.piece);
  return pieces;
}

inline std::vector<SurfacePair> pairs_of(const Prepared& prepared, Refinement refinement) {
  return pair_simplices(
      prepared.surface, SizedSide{*prepared.inside, prepared.sizes_on(Side::inside)},
      SizedSide{*prepared.outside, prepared.sizes_on(Side::outside)}, {refinement});
}

/// What differs between the killing pieces of PAIR and those of the dual pass, under the order by
/// size; empty if nothing does. Adds the number of killing pieces to `compared`.
template <class Count>
std::string difference_of_engines(const Prepared& prepared, Count& compared) {
  if (prepared.surface.points.empty()) return "";
  const std::vector<SurfacePair> pairs = pairs_of(prepared, Refinement::both);
  for (const Side side : {Side::inside, Side::outside}) {
    const std::vector<std::uint32_t> expected = killing_pieces(prepared.pass_on(side));
    if (killing_pieces(pairs, side) != expected)
      return side == Side::inside ? "the pieces inside differ" : "the pieces outside differ";
    compared += expected.size();
  }
  return "";
}

}  // namespace isoloop::testing
