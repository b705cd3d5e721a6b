#include "core/complex/octree_complex.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "tests/oracles/octree_comparison.h"
#include "tests/samples/octree_fixture.h"

namespace isoloop {
namespace {

using testing::Prepared;
using testing::PreparedOctree;

template <class List, class Item>
bool holds(const List& list, const Item& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

/// Calls check(octree, side) on the octrees of some volumes, for every grading and both sides.
template <class Check>
void on_octrees(std::uint32_t volumes, const Check& check) {
  for (std::uint32_t seed = 0; seed < volumes; ++seed) {
    const Prepared p(testing::with_room(seed));
    if (p.surface.points.empty()) continue;
    const PreparedOctree made(p, static_cast<int>(seed % 3));
    for (const Side side : {Side::inside, Side::outside}) check(made, side);
  }
}

/// The cell of the octree that a cell of the grid is part of.
std::uint32_t cell_over(const PreparedOctree& made, std::uint32_t grid_cell) {
  const std::uint32_t cubes = made.octree.lattice().vertex_count();
  return grid_cell < cubes ? made.octree.leaf_at(grid_cell)
                           : grid_cell - cubes + made.octree.vertex_count();
}

/// The grid's faces that a minimal face is made of.
std::vector<std::uint32_t> faces_of(const Octree& octree, std::uint32_t piece) {
  const std::uint32_t height = octree.face_height(piece / 3, piece % 3);
  std::vector<std::uint32_t> faces;
  for (std::uint32_t i = 0; i < 1U << height; ++i)
    for (std::uint32_t j = 0; j < 1U << height; ++j)
      faces.push_back(3 * (octree.lattice_vertex(piece / 3) +
                           i * octree.lattice().stride[(piece + 1) % 3] +
                           j * octree.lattice().stride[(piece + 2) % 3]) +
                      piece % 3);
  return faces;
}

/// The grid's edges that a minimal edge is made of.
std::vector<std::uint32_t> parts_of(const Octree& octree, std::uint32_t edge) {
  std::vector<std::uint32_t> parts;
  const std::uint32_t axis = edge % 3;
  for (std::uint32_t i = 0; i < 1U << octree.edge_height(edge / 3, axis); ++i)
    parts.push_back(3 * (octree.lattice_vertex(edge / 3) + i * octree.lattice().stride[axis]) +
                    axis);
  return parts;
}

TEST(OctreeComplex, PiecesAreThoseOfTheGridBetweenTwoLeaves) {
  std::size_t wide = 0;
  on_octrees(45, [&](const PreparedOctree& made, Side side) {
    const OctreeComplex& complex = made.complex(side);
    const GridComplex& grid = made.prepared.complex(side);
    std::map<std::uint32_t, std::uint32_t> piece_over;  // of a piece of the grid
    for (const std::uint32_t piece : all_pieces(complex)) {
      std::vector<std::uint32_t> parts;
      if (piece >= complex.edge_bound())
        parts = {piece - complex.edge_bound() + grid.edge_bound()};
      else
        parts = faces_of(made.octree, piece);
      wide += parts.size() > 4 ? 1 : 0;
      for (const std::uint32_t part : parts) {
        ASSERT_TRUE(piece_over.emplace(part, piece).second);
        const auto [below, above] = grid.cells(part);
        ASSERT_EQ(complex.cells(piece),
                  (std::array<std::uint32_t, 2>{cell_over(made, below), cell_over(made, above)}));
      }
    }
    for (const std::uint32_t part : all_pieces(grid)) {
      const auto [below, above] = grid.cells(part);
      if (below == above) continue;  // a wall
      ASSERT_EQ(piece_over.count(part) != 0, cell_over(made, below) != cell_over(made, above));
    }
  });
  EXPECT_GT(wide, 1000U);
}

TEST(OctreeComplex, BordersAreThoseOfTheGridsPieces) {
  on_octrees(45, [&](const PreparedOctree& made, Side side) {
    const OctreeComplex& complex = made.complex(side);
    const GridComplex& grid = made.prepared.complex(side);
    for (const std::uint32_t piece : all_pieces(complex)) {
      std::set<std::uint32_t> expected;  // modulo 2
      std::vector<std::uint32_t> faces{piece - complex.edge_bound() + grid.edge_bound()};
      if (piece < complex.edge_bound()) faces = faces_of(made.octree, piece);
      for (const std::uint32_t face : faces)
        for (const std::uint32_t edge : grid.edges_of(face))
          if (!expected.insert(edge).second) expected.erase(edge);
      std::set<std::uint32_t> found;
      for (const std::uint32_t edge : complex.edges_of(piece))
        for (const std::uint32_t part : parts_of(made.octree, edge))
          ASSERT_TRUE(found.insert(part).second);
      ASSERT_EQ(found, expected);
    }
  });
}

TEST(OctreeComplex, RingsAndBordersAreEachOthersTranspose) {
  on_octrees(45, [&](const PreparedOctree& made, Side side) {
    const OctreeComplex& complex = made.complex(side);
    std::size_t incidences = 0;
    for (const std::uint32_t piece : all_pieces(complex))
      for (const std::uint32_t edge : complex.edges_of(piece)) {
        ++incidences;
        ASSERT_TRUE(holds(complex.ring(edge), piece));
      }
    for (const std::uint32_t edge : all_edges(complex)) incidences -= complex.ring(edge).count;
    ASSERT_EQ(incidences, 0U);
  });
}

TEST(OctreeComplex, NeighboursInARingShareACell) {
  on_octrees(45, [&](const PreparedOctree& made, Side side) {
    const OctreeComplex& complex = made.complex(side);
    for (const std::uint32_t edge : all_edges(complex)) {
      const auto ring = complex.ring(edge);
      for (std::uint32_t i = 0; i < ring.count; ++i) {
        const auto here = complex.cells(ring[i]);
        const auto next = complex.cells(ring[(i + 1) % ring.count]);
        ASSERT_TRUE(holds(next, here[0]) || holds(next, here[1]));
      }
    }
  });
}

TEST(OctreeComplex, LayersHoldTheCellsThatTheirPiecesTouch) {
  on_octrees(30, [&](const PreparedOctree& made, Side side) {
    const OctreeComplex& complex = made.complex(side);
    std::uint32_t last = 0;
    for (std::uint32_t layer = 0; layer + 1 < complex.layer_count(); ++layer)
      complex.for_each_piece(layer, [&](std::uint32_t piece) {
        ASSERT_GE(piece, last);
        last = piece;
        for (const std::uint32_t cell : complex.cells(piece)) {
          if (cell >= complex.first_cell(complex.layer_count())) continue;  // of no layer
          ASSERT_GE(cell, complex.first_cell(layer == 0 ? 0 : layer - 1));
          ASSERT_LT(cell, complex.first_cell(layer + 1));
        }
      });
  });
}

TEST(OctreeComplex, PairAndThePassFindTheSameKillingPieces) {
  std::atomic<std::size_t> compared = 0;
  tbb::parallel_for(std::uint32_t{0}, std::uint32_t{120}, [&](std::uint32_t seed) {
    EXPECT_EQ(testing::difference_on_octree(seed, compared), "") << "volume " << seed;
  });
  EXPECT_GT(compared, 500U);
}

}  // namespace
}  // namespace isoloop
