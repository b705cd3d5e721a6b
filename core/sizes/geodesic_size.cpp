#include "core/sizes/geodesic_size.h"

#include <algorithm>
#include <array>
#include <utility>

#include <tbb/parallel_for.h>

#include "core/sizes/sizes_by_ends.h"

namespace isoloop {
namespace {

/// Which vertices of M are closest to the ends of K's edges that are grid edges or halves of them.
struct Ends {
  const VoxelSides& sides;
  const EdgeIndex& edges;
  std::span<const std::uint32_t> closest;  // by lattice vertex

  std::uint32_t upper_end(std::uint32_t edge) const {
    return edge / 3 + sides.lattice.stride[edge % 3];
  }
  bool is_cut(std::uint32_t edge) const {
    return sides.inside[edge / 3] != sides.inside[upper_end(edge)];
  }

  /// Of a cut edge: of its inside half.
  std::array<std::uint32_t, 2> of(std::uint32_t edge) const {
    const std::uint32_t v = edge / 3;
    const std::uint32_t w = upper_end(edge);
    if (!is_cut(edge)) return {closest[v], closest[w]};
    return {closest[sides.is_on(Side::inside, v) ? v : w], edges.vertex_on(edge)};
  }

  std::array<std::uint32_t, 2> of_outside_half(std::uint32_t edge) const {
    const std::uint32_t v = edge / 3;
    return {closest[sides.is_on(Side::outside, v) ? v : upper_end(edge)], edges.vertex_on(edge)};
  }

  /// Whether a full edge of lesser number and the same direction, next to this one in the numbering
  /// of the lattice, has the same ends: most do, for what is closest to one vertex of M is long and
  /// thin. `not_zero`: edges_of_size(). It tells what is an edge of the box: at the box's border
  /// the next number may be none.
  bool are_those_of_a_lesser(std::uint32_t edge, const std::array<std::uint32_t, 2>& ends,
                             const EdgeSet& not_zero) const {
    for (const std::uint32_t step : sides.lattice.stride) {
      if (edge / 3 < step) return false;
      const std::uint32_t beside = edge - 3 * step;
      if (closest[beside / 3] == ends[0] && not_zero[beside] &&
          closest[upper_end(beside)] == ends[1] && !is_cut(beside))
        return true;
    }
    return false;
  }
};

/// The edges whose size is not 0, but for outside halves.
EdgeSet edges_of_size(const Ends& ends) {
  const Lattice& lattice = ends.sides.lattice;
  return EdgeSet(lattice.vertex_count(), [&](std::uint32_t block) {
    EdgeSet::BlockBits not_zero{};
    const std::uint32_t end = std::min(64 * block + 64, lattice.vertex_count());
    auto position = lattice.position(64 * block);
    for (std::uint32_t v = 64 * block; v < end; ++v) {
      for (std::uint32_t a = 0; a < 3; ++a) {
        if (position[a] + 1 == lattice.dims[a]) continue;
        const std::uint32_t w = v + lattice.stride[a];
        const bool is_full = ends.sides.inside[v] == ends.sides.inside[w];
        const bool differ = ends.closest[v] != ends.closest[w];
        not_zero[a] |= std::uint64_t{is_full && differ} << (v % 64);
      }
      for (int a = 0; a < 3 && ++position[a] == lattice.dims[a]; ++a) position[a] = 0;
    }
    ends.edges.visit_block(block, [&](std::uint32_t, std::uint32_t edge) {
      const auto [a, b] = ends.of(edge);
      not_zero[edge % 3] |= std::uint64_t{a != b} << (edge / 3 % 64);
    });
    return not_zero;
  });
}

/// Calls visit(ends) for those that are to be searched for, some of them repeatedly, and from many
/// threads.
template <class Visit>
void for_each_ends(const Ends& ends, const EdgeSet& not_zero, const Visit& visit) {
  tbb::parallel_for(std::uint32_t{0}, not_zero.block_count(), [&](std::uint32_t block) {
    not_zero.visit_block(block, [&](std::uint32_t, std::uint32_t edge) {
      const auto pair = ends.of(edge);
      if (!ends.are_those_of_a_lesser(edge, pair, not_zero)) visit(pair);
    });
    ends.edges.visit_block(
        block, [&](std::uint32_t, std::uint32_t edge) { visit(ends.of_outside_half(edge)); });
  });
}

}  // namespace

EdgeSizes geodesic_sizes(const VoxelSides& sides, const EdgeIndex& edges, const Surface& surface,
                         std::span<const std::uint32_t> closest, GeodesicMode mode) {
  const Ends ends{sides, edges, closest};
  EdgeSet not_zero = edges_of_size(ends);
  const SizesByEnds by_ends(surface, mode,
                            [&](const auto& visit) { for_each_ends(ends, not_zero, visit); });
  EdgeSizes sizes;
  sizes.by_edge = SparseSizes(std::move(not_zero));
  sizes.by_edge.set_all([&](std::uint32_t edge) { return by_ends.of(ends.of(edge)); });
  sizes.of_outside_half.resize(surface.points.size());
  tbb::parallel_for(std::uint32_t{0}, edges.block_count(), [&](std::uint32_t block) {
    edges.visit_block(block, [&](std::uint32_t vertex, std::uint32_t edge) {
      sizes.of_outside_half[vertex] = by_ends.of(ends.of_outside_half(edge));
    });
  });
  return sizes;
}

}  // namespace isoloop
