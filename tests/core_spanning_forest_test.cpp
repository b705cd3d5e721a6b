#include <gtest/gtest.h>

#include "core/disjoint_sets.h"
#include "core/order.h"
#include "core/spanning_forest.h"
#include "tests/core_fixture.h"

namespace isoloop {
namespace {

TEST(SpanningForest, IsTheOneThatKruskalFindsWithTheLargestPiecesFirst) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    // Voxels of either sign: many equal sizes. Smoothed ones: many cells of size 0.
    const testing::Prepared p(seed % 2 == 0 ? testing::white_noise({7, 6, 28}, seed)
                                            : testing::smooth_noise({11, 12, 30}, seed, 2));
    if (p.surface.points.empty()) continue;
    for (const Side side : {Side::inside, Side::outside}) {
      const GridComplex& complex = p.complex(side);
      const BitSet forest = largest_forest(complex);
      DisjointSets cells(complex.cell_bound());
      for (const std::uint32_t piece : pieces_from_largest(complex)) {
        const auto [a, b] = complex.cells(piece);
        ASSERT_EQ(forest[piece], cells.unite(a, b)) << "seed " << seed << ", piece " << piece;
      }
    }
  }
}

}  // namespace
}  // namespace isoloop
