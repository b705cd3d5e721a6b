// The two engines against each other on the octree of one volume.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/engines/dual_pass.h"
#include "core/engines/pair.h"
#include "tests/oracles/pair_comparison.h"
#include "tests/samples/octree_fixture.h"
#include "tests/samples/random_sizes.h"

namespace isoloop::testing {

/// What differs between PAIR and the pass under these sizes; empty if nothing does.
template <Sizes S, class Count>
std::string difference_under(const PreparedOctree& made, const S& inside, const S& outside,
                             Count& compared) {
  const std::vector<SurfacePair> pairs = pair_simplices(
      made.prepared.surface, SizedSide{made.inside, inside}, SizedSide{made.outside, outside});
  for (const Side side : {Side::inside, Side::outside}) {
    const DualPass pass = dual_pass(made.complex(side), side == Side::inside ? inside : outside);
    if (!labels_are_consistent(made.complex(side), pass)) return "the labels do not sum to 0";
    const std::vector<std::uint32_t> expected = killing_pieces(pass);
    if (static_cast<std::int64_t>(expected.size()) != made.prepared.surface.genus())
      return "not as many as the genus";
    if (killing_pieces(pairs, side) != expected) return "the killing pieces differ";
    compared += expected.size();
  }
  return "";
}

/// The same for volume `seed` of with_room(), under geodesic sizes and under random ones.
template <class Count>
std::string difference_on_octree(std::uint32_t seed, Count& compared) {
  const Prepared p(with_room(seed), GeodesicMode::hierarchy);
  if (p.surface.points.empty()) return "";
  const PreparedOctree made(p, static_cast<int>(seed / 2 % 3), GeodesicMode::hierarchy);
  std::string difference =
      difference_under(made, made.sizes_on(Side::inside), made.sizes_on(Side::outside), compared);
  if (!difference.empty()) return difference;
  std::mt19937 random(seed);
  const std::uint32_t sizes = seed % 4 < 2 ? 1000 : 4;
  const FlatSizes inside = random_sizes(made.inside, sizes, random);
  const FlatSizes outside = random_sizes(made.outside, sizes, random);
  difference = difference_under(made, inside, outside, compared);
  return difference.empty() ? "" : difference + " under random sizes";
}

}  // namespace isoloop::testing
