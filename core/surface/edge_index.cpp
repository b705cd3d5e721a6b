#include "core/surface/edge_index.h"

#include <algorithm>
#include <bit>
#include <limits>

#include <boost/sort/spreadsort/integer_sort.hpp>
#include <tbb/parallel_for.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

/// Spreads the low ten bits to every third place.
std::uint32_t every_third_bit(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ffU;
  x = (x | x << 8) & 0x0300f00fU;
  x = (x | x << 4) & 0x030c30c3U;
  return (x | x << 2) & 0x09249249U;
}

/// log2 of the side of bricks: as small as ten bits a brick coordinate allow.
int brick_bits(const Lattice& lattice) {
  const std::uint32_t most = *std::max_element(lattice.dims.begin(), lattice.dims.end());
  int bits = 2;
  while (most >> bits > 1023) ++bits;
  return bits;
}

/// Place of the lattice vertex's brick along Morton's curve.
std::uint32_t brick_place(const Lattice& lattice, std::uint32_t vertex, int bits) {
  const auto p = lattice.position(vertex);
  return every_third_bit(p[0] >> bits) | every_third_bit(p[1] >> bits) << 1 |
         every_third_bit(p[2] >> bits) << 2;
}

/// The cut edges at 64 lattice vertices.
EdgeSet::BlockBits cut_edges(const VoxelSides& sides, std::uint32_t b) {
  const std::uint32_t vertices = sides.lattice.vertex_count();
  EdgeSet::BlockBits cut{};
  for (std::uint32_t a = 0; a < 3; ++a) {
    const std::uint32_t stride = sides.lattice.stride[a];
    for (std::uint32_t i = 0, v = 64 * b; i < 64 && v + stride < vertices; ++i, ++v)
      cut[a] |= std::uint64_t{static_cast<std::uint8_t>(sides.inside[v] ^ sides.inside[v + stride])}
                << i;
    // The last vertex along an axis has no edge along it: its bit compares it with a vertex that
    // follows it in number alone.
    for (std::uint64_t left = cut[a]; left != 0; left &= left - 1) {
      const auto i = static_cast<std::uint32_t>(std::countr_zero(left));
      if (sides.lattice.position(64 * b + i)[a] + 1 == sides.lattice.dims[a])
        cut[a] ^= std::uint64_t{1} << i;
    }
  }
  return cut;
}

}  // namespace

EdgeIndex::EdgeIndex(const VoxelSides& sides)
    : cut_(sides.lattice.vertex_count(), [&](std::uint32_t b) { return cut_edges(sides, b); }) {
  if (count() > std::numeric_limits<std::uint32_t>::max() / 12)
    throw LimitExceeded({.text = "the surface has too many vertices for 32-bit indices",
                         .advice = {Advice::take_part}});
  number_.resize(count());
  std::vector<std::uint64_t> places(count());
  const int bits = brick_bits(sides.lattice);
  tbb::parallel_for(std::uint32_t{0}, block_count(), [&](std::uint32_t b) {
    cut_.visit_block(b, [&](std::uint32_t rank, std::uint32_t grid_edge) {
      places[rank] =
          std::uint64_t{brick_place(sides.lattice, grid_edge / 3, bits)} << 32 | grid_edge;
    });
  });
  boost::sort::spreadsort::integer_sort(places.begin(), places.end());
  for (std::uint32_t v = 0; v < count(); ++v)
    number_[cut_.rank(static_cast<std::uint32_t>(places[v]))] = v;
}

}  // namespace isoloop
