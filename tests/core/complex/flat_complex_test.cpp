#include "core/complex/flat_complex.h"

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/engines/dual_pass.h"
#include "core/engines/pair.h"
#include "tests/oracles/pair_comparison.h"
#include "tests/oracles/tetrahedra.h"
#include "tests/samples/core_fixture.h"
#include "tests/samples/random_sizes.h"

namespace isoloop {
namespace {

using testing::killing_pieces;
using testing::Prepared;
using testing::random_sizes;

std::vector<std::vector<std::uint32_t>> labels_of(const DualPass& pass, std::uint32_t bound) {
  std::vector<std::vector<std::uint32_t>> labels;
  for (std::uint32_t piece = 0; piece < bound; ++piece) {
    const auto set = pass.pool.generators(pass.labels[piece]);
    labels.emplace_back(set.begin(), set.end());
  }
  return labels;
}

FlatSizes sizes_of_copy(const GridComplex& complex, const GridSizes& sizes) {
  FlatSizes copy;
  for (const std::uint32_t piece : all_pieces(complex))
    copy.by_piece.push_back(sizes.of_piece(piece));
  copy.by_edge.resize(complex.edge_bound());
  for (const std::uint32_t edge : all_edges(complex)) copy.by_edge[edge] = sizes.of_edge(edge);
  return copy;
}

TEST(FlatComplex, RingsAndBordersAreEachOthersTranspose) {
  const FlatComplex complex(2, 5, std::vector<FlatPiece>{{{0, 1}, {4, 1}}, {{1, 0}, {1}}});
  EXPECT_EQ(all_pieces(complex), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(all_edges(complex), (std::vector<std::uint32_t>{1, 4}));
  const auto ring = complex.ring(1);
  EXPECT_EQ(std::vector(ring.begin(), ring.end()), (std::vector<std::uint32_t>{0, 1}));
  const auto edges = complex.edges_of(0);
  EXPECT_EQ(std::vector(edges.begin(), edges.end()), (std::vector<std::uint32_t>{1, 4}));
  EXPECT_TRUE(complex.segments(1).empty());
}

TEST(FlatComplex, ACopyOfAGridHasItsKillingPiecesAndLabels) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const Prepared p(seed % 2 == 0 ? testing::white_noise({7, 6, 8}, seed)
                                   : testing::smooth_noise({11, 10, 12}, seed, 1));
    if (p.surface.points.empty()) continue;
    for (const Side side : {Side::inside, Side::outside}) {
      const GridComplex& grid = p.complex(side);
      const std::vector<std::uint32_t> numbers = all_pieces(grid);
      const FlatComplex copy = flattened(grid);
      const DualPass of_copy = dual_pass(copy, sizes_of_copy(grid, p.sizes_on(side)));
      const DualPass of_grid = p.pass_on(side);
      EXPECT_TRUE(labels_are_consistent(copy, of_copy));
      ASSERT_EQ(of_copy.killing.size(), of_grid.killing.size());
      for (std::size_t i = 0; i < of_grid.killing.size(); ++i) {
        EXPECT_EQ(numbers[of_copy.killing[i].piece], of_grid.killing[i].piece);
        EXPECT_EQ(of_copy.killing[i].size, of_grid.killing[i].size);
      }
      const auto copied = labels_of(of_copy, copy.piece_bound());
      const auto labels = labels_of(of_grid, grid.piece_bound());
      for (std::size_t i = 0; i < numbers.size(); ++i) ASSERT_EQ(copied[i], labels[numbers[i]]);
    }
  }
}

TEST(FlatComplex, ACopyOfAGridIsPairedAsTheGridIs) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Prepared p(testing::white_noise({6, 7, 6}, seed));
    const FlatComplex inside = flattened(*p.inside);
    const FlatComplex outside = flattened(*p.outside);
    const std::vector<SurfacePair> copied = pair_simplices(
        p.surface, SizedSide{inside, sizes_of_copy(*p.inside, p.sizes_on(Side::inside))},
        SizedSide{outside, sizes_of_copy(*p.outside, p.sizes_on(Side::outside))});
    const std::vector<SurfacePair> pairs = testing::pairs_of(p, Refinement::both);
    ASSERT_EQ(copied.size(), pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_EQ(all_pieces(p.complex(pairs[i].side))[copied[i].piece], pairs[i].piece);
      EXPECT_EQ(copied[i].edge, pairs[i].edge);
      EXPECT_EQ(copied[i].cycle, pairs[i].cycle);
    }
    EXPECT_EQ(fan_triangle_count(inside), fan_triangle_count(*p.inside));
  }
}

TEST(FlatComplex, TheWorkedExampleComesOutAsDocumented) {
  enum Cell : std::uint32_t { l, r, a, c, u, v };
  // In docs/dual_pass.md: a, a', m, c, u, u', v, v', c'. Edge 0 is e, edge 1 is e'.
  const FlatComplex complex(6, 2,
                            std::vector<FlatPiece>{{{l, a}, {}},
                                                   {{a, r}, {}},
                                                   {{u, v}, {0, 1}},
                                                   {{l, c}, {}},
                                                   {{l, u}, {0}},
                                                   {{u, r}, {1}},
                                                   {{l, v}, {0}},
                                                   {{v, r}, {1}},
                                                   {{c, r}, {}}});
  const FlatSizes sizes{{9.0F, 8.0F, 7.0F, 6.0F, 5.0F, 4.0F, 3.5F, 3.0F, 2.0F}};
  const DualPass pass = dual_pass(complex, sizes);
  EXPECT_EQ(killing_pieces(pass), (std::vector<std::uint32_t>{8, 5}));
  using Labels = std::vector<std::vector<std::uint32_t>>;
  EXPECT_EQ(labels_of(pass, 9), (Labels{{}, {}, {}, {}, {}, {1}, {}, {1}, {0}}));
  EXPECT_TRUE(labels_are_consistent(complex, pass));
}

/// Of a ring and of a figure of eight.
TEST(FlatComplex, BothEnginesAgreeOnTetrahedraOfAnySizes) {
  const std::vector<std::vector<std::string>> shapes{{"###", "#.#", "###"},
                                                     {"#####", "#.#.#", "#####"}};
  for (std::size_t genus = 1; genus <= 2; ++genus) {
    const oracle::TetrahedralVolume volume = oracle::tetrahedra_of(shapes[genus - 1]);
    ASSERT_EQ(volume.surface.genus(), static_cast<std::int64_t>(genus));
    std::mt19937 random(3);
    for (int trial = 0; trial < 60; ++trial) {
      const FlatSizes inside = random_sizes(volume.inside, 40, random);
      const FlatSizes outside = random_sizes(volume.outside, 40, random);
      const std::vector<SurfacePair> pairs = pair_simplices(
          volume.surface, SizedSide{volume.inside, inside}, SizedSide{volume.outside, outside});
      const DualPass of_inside = dual_pass(volume.inside, inside);
      const DualPass of_outside = dual_pass(volume.outside, outside);
      ASSERT_EQ(of_inside.killing.size(), genus);
      EXPECT_EQ(killing_pieces(pairs, Side::inside), killing_pieces(of_inside));
      EXPECT_EQ(killing_pieces(pairs, Side::outside), killing_pieces(of_outside));
      EXPECT_TRUE(labels_are_consistent(volume.inside, of_inside));
      EXPECT_TRUE(labels_are_consistent(volume.outside, of_outside));
    }
  }
}

}  // namespace
}  // namespace isoloop
