#include "core/complex/octree_sizes.h"

#include <array>
#include <utility>

#include <tbb/parallel_for.h>

#include "core/base/bit_set.h"
#include "core/sizes/sizes_by_ends.h"

namespace isoloop {
namespace {

/// Which vertices of M are closest to the ends of K's edges.
struct Ends {
  const Octree& octree;
  const EdgeIndex& edges;
  std::span<const std::uint32_t> closest;  // by vertex of the octree

  /// Of the half of a cut edge that lies on a side.
  SizesByEnds::Ends of_half(std::uint32_t edge, Side side) const {
    const std::uint32_t v = edge / 3;
    const std::uint32_t axis = edge % 3;
    const bool is_first = octree.is_inside(v) == (side == Side::inside);
    const std::uint32_t on = edges.vertex_on(3 * octree.lattice_vertex(v) + axis);
    return {closest[is_first ? v : octree.end_of(v, axis, 0)], on};
  }

  /// Of a minimal edge or, if M cuts it, of its inside half.
  SizesByEnds::Ends of(std::uint32_t edge) const {
    const std::uint32_t v = edge / 3;
    const std::uint32_t axis = edge % 3;
    if (octree.is_edge_cut(v, axis)) return of_half(edge, Side::inside);
    return {closest[v], closest[octree.end_of(v, axis, octree.edge_height(v, axis))]};
  }

  SizesByEnds::Ends of_side(std::uint32_t edge) const {
    const std::uint32_t v = edge / 3;
    const std::uint32_t axis = edge % 3;
    return {closest[v], closest[octree.end_of(v, axis, octree.edge_height(v, axis) + 1)]};
  }
};

/// The edges, of those that is_there(vertex, axis) names, whose ends_of(edge) differ.
template <class IsThere, class EndsOf>
EdgeSet edges_of_size(const Octree& octree, const IsThere& is_there, const EndsOf& ends_of) {
  return EdgeSet(octree.vertex_count(), [&](std::uint32_t block) {
    EdgeSet::BlockBits not_zero{};
    const std::uint32_t end = std::min(64 * block + 64, octree.vertex_count());
    for (std::uint32_t v = 64 * block; v < end; ++v)
      for (std::uint32_t a = 0; a < 3; ++a) {
        if (!is_there(v, a)) continue;
        const auto [from, to] = ends_of(3 * v + a);
        not_zero[a] |= std::uint64_t{from != to} << (v % 64);
      }
    return not_zero;
  });
}

/// By the number of the first edge.
BitSet sides_of_two_edges(const Octree& octree) {
  BitSet sides(3 * octree.vertex_count());
  tbb::parallel_for(std::uint32_t{0}, octree.vertex_count(), [&](std::uint32_t v) {
    for (std::uint32_t a = 0; a < 3; ++a) {
      const std::uint32_t height = octree.face_height(v, a);
      if (height == 0 || height == Octree::none) continue;
      octree.for_each_side(v, a, [&](std::uint32_t first, std::uint32_t along, bool is_one) {
        if (!is_one) sides.insert_shared(3 * first + along);
      });
    }
  });
  return sides;
}

}  // namespace

OctreeEdgeSizes octree_edge_sizes(const Octree& octree, const EdgeIndex& edges,
                                  const Surface& surface, std::span<const std::uint32_t> closest,
                                  GeodesicMode mode) {
  const Ends ends{octree, edges, closest};
  const BitSet two_edges = sides_of_two_edges(octree);
  EdgeSet of_edges = edges_of_size(
      octree,
      [&](std::uint32_t v, std::uint32_t a) { return octree.edge_height(v, a) != Octree::none; },
      [&](std::uint32_t edge) { return ends.of(edge); });
  EdgeSet of_sides = edges_of_size(
      octree, [&](std::uint32_t v, std::uint32_t a) { return two_edges[3 * v + a]; },
      [&](std::uint32_t edge) { return ends.of_side(edge); });
  const auto for_each_cut = [&](const auto& visit) {
    tbb::parallel_for(std::uint32_t{0}, edges.block_count(), [&](std::uint32_t block) {
      edges.visit_block(block, [&](std::uint32_t on, std::uint32_t grid_edge) {
        const std::uint32_t edge = 3 * octree.vertex_at(grid_edge / 3) + grid_edge % 3;
        visit(on, ends.of_half(edge, Side::outside));
      });
    });
  };
  const SizesByEnds by_ends(surface, mode, [&](const auto& visit) {
    tbb::parallel_for(std::uint32_t{0}, of_edges.block_count(), [&](std::uint32_t block) {
      of_edges.visit_block(block, [&](std::uint32_t, std::uint32_t edge) { visit(ends.of(edge)); });
      of_sides.visit_block(block,
                           [&](std::uint32_t, std::uint32_t edge) { visit(ends.of_side(edge)); });
    });
    for_each_cut([&](std::uint32_t, const SizesByEnds::Ends& half) { visit(half); });
  });
  OctreeEdgeSizes sizes;
  sizes.by_edge = SparseSizes(std::move(of_edges));
  sizes.by_edge.set_all([&](std::uint32_t edge) { return by_ends.of(ends.of(edge)); });
  sizes.by_side = SparseSizes(std::move(of_sides));
  sizes.by_side.set_all([&](std::uint32_t edge) { return by_ends.of(ends.of_side(edge)); });
  sizes.of_outside_half.resize(surface.points.size());
  for_each_cut([&](std::uint32_t on, const SizesByEnds::Ends& half) {
    sizes.of_outside_half[on] = by_ends.of(half);
  });
  return sizes;
}

float OctreeSizes::of_piece(std::uint32_t piece) const {
  float largest = 0.0F;
  if (complex_.is_of_grid(piece)) {
    for (const std::uint32_t edge : complex_.edges_of(piece))
      largest = std::max(largest, of_edge(edge));
    return largest;
  }
  const Octree& octree = complex_.octree();
  octree.for_each_side(piece / 3, piece % 3, [&](std::uint32_t v, std::uint32_t a, bool is_one) {
    largest = std::max(largest, sizes_.by_edge[3 * v + a]);
    if (is_one) return;
    largest = std::max(largest, sizes_.by_side[3 * v + a]);
    const std::uint32_t middle = octree.end_of(v, a, octree.edge_height(v, a));
    largest = std::max(largest, sizes_.by_edge[3 * middle + a]);
  });
  return largest;
}

}  // namespace isoloop
