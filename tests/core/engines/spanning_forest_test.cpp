#include "core/engines/spanning_forest.h"

#include <array>

#include <gtest/gtest.h>

#include "core/base/disjoint_sets.h"
#include "core/base/threads.h"
#include "core/complex/order.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

/// By so many threads, which decide how thick the slabs are.
BitSet forest_by(int threads, const GridComplex& complex, const GridSizes& sizes) {
  return with_threads(threads, [&] { return largest_forest(complex, sizes); });
}

TEST(SpanningForest, IsTheOneThatKruskalFindsWithTheLargestPiecesFirst) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    // Voxels of either sign: many equal sizes. Smoothed ones: many cells of size 0.
    const testing::Prepared p(seed % 2 == 0 ? testing::white_noise({6, 5, 52}, seed)
                                            : testing::smooth_noise({9, 10, 52}, seed, 2));
    if (p.surface.points.empty()) continue;
    for (const Side side : {Side::inside, Side::outside}) {
      const GridComplex& complex = p.complex(side);
      const GridSizes sizes = p.sizes_on(side);
      const std::array forests{forest_by(1, complex, sizes), forest_by(3, complex, sizes),
                               forest_by(8, complex, sizes)};
      DisjointSets cells(complex.cell_bound());
      for (const std::uint32_t piece : from_largest(sizes, all_pieces(complex))) {
        const auto [a, b] = complex.cells(piece);
        const bool is_in = cells.unite(a, b);
        for (const BitSet& forest : forests)
          ASSERT_EQ(forest[piece], is_in) << "seed " << seed << ", piece " << piece;
      }
    }
  }
}

}  // namespace
}  // namespace isoloop
