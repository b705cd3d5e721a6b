#include "core/loops/pair_loops.h"

#include <algorithm>
#include <tuple>

namespace isoloop {

std::vector<Loop> loops_of_pairs(const Surface& surface, std::span<const SurfacePair> pairs) {
  std::vector<const SurfacePair*> sorted;
  for (const SurfacePair& pair : pairs) sorted.push_back(&pair);
  const auto kind_of = [&](const SurfacePair* pair) {
    return kind_on(surface.boundary, pair->side);
  };
  const auto key = [&](const SurfacePair* pair) {
    return std::tuple(kind_of(pair), pair->size, pair->piece, pair->side == Side::outside);
  };
  std::sort(sorted.begin(), sorted.end(),
            [&](const SurfacePair* a, const SurfacePair* b) { return key(a) < key(b); });
  std::vector<Loop> loops;
  for (const SurfacePair* pair : sorted) {
    const LoopKind kind = kind_of(pair);
    const int id = !loops.empty() && loops.back().kind == kind ? loops.back().id + 1 : 1;
    loops.push_back(measured_loop(surface, kind, id, pair->size, closed_curves(pair->cycle)));
  }
  return loops;
}

}  // namespace isoloop
