// PAIR as the paper states it, one triangle after another, for small volumes: the oracle of
// core/pair. It reduces every triangle of M and of every fan, and skips nothing.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "core/engines/pair.h"
#include "tests/samples/core_fixture.h"

namespace isoloop::testing {

struct LiteralPair {
  std::uint32_t piece = 0;
  std::set<std::array<std::uint32_t, 2>> cycle;  // edges of M
};

/// In the order in which they kill. M's edges and triangles are in the order of core/surface_order,
/// which the paper leaves open.
std::vector<LiteralPair> literal_pairs(const Prepared& prepared, Side side, Refinement refinement);

}  // namespace isoloop::testing
