#include "core/edge_index.h"

#include <limits>

#include <tbb/parallel_for.h>

#include "core/errors.h"

namespace isoloop {

EdgeIndex::EdgeIndex(const Sides& sides) {
  const std::uint32_t vertices = sides.lattice.vertex_count();
  blocks_.resize((vertices + 63) / 64);
  // The last vertex along each axis is outside and so is the first: an edge that would wrap round
  // the box's border joins two outside vertices and never counts as cut.
  tbb::parallel_for(std::uint32_t{0}, block_count(), [&](std::uint32_t b) {
    for (std::uint32_t a = 0; a < 3; ++a) {
      std::uint64_t bits = 0;
      const std::uint32_t stride = sides.lattice.stride[a];
      for (std::uint32_t i = 0, v = 64 * b; i < 64 && v + stride < vertices; ++i, ++v)
        bits |= std::uint64_t{static_cast<std::uint8_t>(sides.inside[v] ^ sides.inside[v + stride])}
                << i;
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
}

}  // namespace isoloop
