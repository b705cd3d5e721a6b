// The loops of a random surface beside the least that they could come to.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "core/loops/certificate.h"
#include "core/loops/loops.h"
#include "core/tighten/shortest_basis.h"
#include "tests/oracles/exact_basis.h"
#include "tests/samples/core_fixture.h"

namespace isoloop::testing {

/// Everything up to the loops as the pass finds them.
struct WithLoops {
  explicit WithLoops(const SmallVolume& volume, GeodesicMode mode = GeodesicMode::hierarchy)
      : prepared(volume, mode),
        inside(prepared.pass_on(Side::inside)),
        outside(prepared.pass_on(Side::outside)),
        classes(surface_classes(prepared.surface, *prepared.inside, inside, *prepared.outside,
                                outside)),
        inside_borders(killing_borders(*prepared.inside, inside)),
        outside_borders(killing_borders(*prepared.outside, outside)),
        inside_classes(border_classes(prepared.surface, classes, Side::inside, inside_borders)),
        outside_classes(border_classes(prepared.surface, classes, Side::outside, outside_borders)),
        handles(search_on(*prepared.inside, inside, inside_borders, inside_classes).loops),
        tunnels(search_on(*prepared.outside, outside, outside_borders, outside_classes).loops) {}

  void shorten(const BasisEffort& effort = {}) {
    const std::vector<Loop> all = certified(prepared.surface, classes, all_loops());
    const SideLoops in{loops_of_kind(all, LoopKind::handle), inside_classes};
    const SideLoops out{loops_of_kind(all, LoopKind::tunnel), outside_classes};
    const ShortenedBasis short_handles = shorten_basis(prepared.surface, classes, in, out, effort);
    const ShortenedBasis short_tunnels = shorten_basis(
        prepared.surface, classes, out, {short_handles.loops, inside_classes}, effort);
    handles = short_handles.loops;
    tunnels = short_tunnels.loops;
    handle_bound = short_handles.least_length;
    tunnel_bound = short_tunnels.least_length;
  }

  std::vector<Loop> all_loops() const {
    std::vector<Loop> all = handles;
    all.insert(all.end(), tunnels.begin(), tunnels.end());
    return all;
  }

  SearchedLoops search_on(const GridComplex& complex, const DualPass& pass,
                          const KillingBorders& borders, const Z2Basis& classes_there) const {
    const std::vector<Curve> starts = starts_near(
        complex, pass.killing, [&](std::uint32_t corner) { return prepared.closest[corner]; });
    return loops_of_side(prepared.surface, classes,
                         {complex.side(), pass.killing, starts, borders, classes_there});
  }

  Prepared prepared;
  DualPass inside;
  DualPass outside;
  SurfaceClasses classes;
  KillingBorders inside_borders;
  KillingBorders outside_borders;
  Z2Basis inside_classes;
  Z2Basis outside_classes;
  std::vector<Loop> handles;
  std::vector<Loop> tunnels;
  double handle_bound = 0.0;
  double tunnel_bound = 0.0;
};

inline double total_length(const std::vector<Loop>& loops) {
  double sum = 0.0;
  for (const Loop& loop : loops) sum += loop.length;
  return sum;
}

inline double least_length(const WithLoops& found, Side side) {
  const std::vector<Loop>& loops = side == Side::inside ? found.handles : found.tunnels;
  double longest = 0.0;
  for (const Loop& loop : loops) longest = std::max(longest, loop.length);
  return least_basis_length(found.prepared.surface, found.classes, side, longest);
}

/// How the loops of many surfaces compare with the least.
struct Tally {
  int surfaces = 0;
  int equal = 0;
  double sum = 0.0;    // of the ratios
  double worst = 0.0;  // ratio

  void add(double ratio) {
    constexpr double rounding = 1e-6;
    ++surfaces;
    equal += ratio < 1.0 + rounding ? 1 : 0;
    sum += ratio;
    worst = std::max(worst, ratio);
  }
};

/// Total length of all loops, handles and tunnels, over the least. Checks the lower bounds too.
inline double shortened_over_least(const SmallVolume& volume) {
  WithLoops loops(volume);
  loops.shorten();
  const double handles = least_length(loops, Side::inside);
  const double tunnels = least_length(loops, Side::outside);
  EXPECT_LE(loops.handle_bound, handles);
  EXPECT_LE(loops.tunnel_bound, tunnels);
  const std::vector<Loop> all = loops.all_loops();
  EXPECT_NO_THROW(certified(loops.prepared.surface, loops.classes, all));
  EXPECT_GT(total_length(all), (handles + tunnels) * (1.0 - 1e-6)) << "shorter than the least";
  return total_length(all) / (handles + tunnels);
}

/// White and smoothed noise of 4 to 13 voxels a side; nothing unless the surface has at most 2 000
/// triangles and genus 1 to 8.
inline std::optional<SmallVolume> small_surface(std::uint32_t seed) {
  const Index3 dims{4 + seed % 10, 4 + seed / 10 % 10, 4 + seed / 100 % 10};
  SmallVolume volume = seed % 4 == 0 ? white_noise(dims, seed)
                                     : smooth_noise(dims, seed, static_cast<int>(seed % 4 / 2 + 1));
  const VoxelSides sides = classify(volume.view(), zero_level);
  const Surface surface = extract_surface(volume.view(), zero_level, sides, EdgeIndex(sides));
  if (surface.triangles.size() > 2000 || surface.genus() < 1 || surface.genus() > 8) return {};
  return volume;
}

}  // namespace isoloop::testing
