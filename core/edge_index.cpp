#include "core/edge_index.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include <boost/sort/spreadsort/integer_sort.hpp>
#include <tbb/parallel_for.h>

#include "core/errors.h"

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

}  // namespace

EdgeIndex::EdgeIndex(const Sides& sides) {
  const std::uint32_t vertices = sides.lattice.vertex_count();
  blocks_.resize((vertices + 63) / 64);
  tbb::parallel_for(std::uint32_t{0}, block_count(), [&](std::uint32_t b) {
    for (std::uint32_t a = 0; a < 3; ++a) {
      std::uint64_t bits = 0;
      const std::uint32_t stride = sides.lattice.stride[a];
      for (std::uint32_t i = 0, v = 64 * b; i < 64 && v + stride < vertices; ++i, ++v)
        bits |= std::uint64_t{static_cast<std::uint8_t>(sides.inside[v] ^ sides.inside[v + stride])}
                << i;
      // The edge that would lead from the last vertex along an axis out of the box is none.
      for (std::uint64_t left = bits; left != 0; left &= left - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(left));
        if (sides.lattice.position(64 * b + i)[a] + 1 == sides.lattice.dims[a])
          bits ^= std::uint64_t{1} << i;
      }
      blocks_[b].cut[a] = bits;
    }
  });
  std::uint64_t total = 0;
  for (Block& block : blocks_) {
    block.first = static_cast<std::uint32_t>(total);
    for (const std::uint64_t bits : block.cut)
      total += static_cast<std::uint64_t>(std::popcount(bits));
    if (total > std::numeric_limits<std::uint32_t>::max() / 12)
      throw LimitExceeded("the surface has too many vertices for 32-bit indices: crop the volume");
  }
  count_ = static_cast<std::uint32_t>(total);
  number_.resize(count_);
  std::iota(number_.begin(), number_.end(), 0U);
  std::vector<std::uint64_t> places(count_);
  const int bits = brick_bits(sides.lattice);
  tbb::parallel_for(std::uint32_t{0}, block_count(), [&](std::uint32_t b) {
    visit_block(b, [&](std::uint32_t rank, std::uint32_t grid_edge) {
      places[rank] = std::uint64_t{brick_place(sides.lattice, grid_edge / 3, bits)} << 32 | rank;
    });
  });
  boost::sort::spreadsort::integer_sort(places.begin(), places.end());
  for (std::uint32_t v = 0; v < count_; ++v) number_[static_cast<std::uint32_t>(places[v])] = v;
}

}  // namespace isoloop
