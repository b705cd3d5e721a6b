#include "core/complex/grid_complex.h"

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using testing::Prepared;

template <class List>
bool holds(const List& list, std::uint32_t item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

TEST(GridComplex, RingsAndBordersAreEachOthersTranspose) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const Prepared p(testing::white_noise({5, 4, 6}, seed));
    for (const Side side : {Side::inside, Side::outside}) {
      const GridComplex& complex = p.complex(side);
      std::size_t incidences = 0;
      for (const std::uint32_t piece : all_pieces(complex))
        for (const std::uint32_t edge : complex.edges_of(piece)) {
          ++incidences;
          ASSERT_TRUE(holds(complex.ring(edge), piece));
        }
      for (const std::uint32_t edge : all_edges(complex)) incidences -= complex.ring(edge).count;
      ASSERT_EQ(incidences, 0U);
    }
  }
}

TEST(GridComplex, NeighboursInARingShareACell) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const Prepared p(testing::white_noise({5, 4, 6}, seed));
    for (const Side side : {Side::inside, Side::outside}) {
      const GridComplex& complex = p.complex(side);
      for (const std::uint32_t edge : all_edges(complex)) {
        const auto ring = complex.ring(edge);
        for (std::uint32_t i = 0; i < ring.count; ++i) {
          const auto here = complex.cells(ring[i]);
          const auto next = complex.cells(ring[(i + 1) % ring.count]);
          ASSERT_TRUE(holds(next, here[0]) || holds(next, here[1]));
        }
      }
    }
  }
}

TEST(GridComplex, CellsPiecesAndEdgesCountTheEulerCharacteristicOfTheCore) {
  // The dual graph with its rings and interior vertices is a spine of the side: its Euler
  // characteristic is that of the side.
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const Prepared p(testing::white_noise({6, 5, 4}, seed));
    const std::int64_t euler = p.surface.euler() / 2;
    for (const Side side : {Side::inside, Side::outside}) {
      const GridComplex& complex = p.complex(side);
      std::set<std::uint32_t> cells;
      for (const std::uint32_t piece : all_pieces(complex))
        for (const std::uint32_t cell : complex.cells(piece)) cells.insert(cell);
      const auto vertices =
          std::count(p.sides.inside.begin(), p.sides.inside.end(), static_cast<std::uint8_t>(side));
      const auto spine = static_cast<std::int64_t>(cells.size()) -
                         static_cast<std::int64_t>(all_pieces(complex).size()) +
                         static_cast<std::int64_t>(all_edges(complex).size()) - vertices;
      EXPECT_EQ(spine, euler) << "seed " << seed;
    }
  }
}

TEST(GridComplex, SegmentsOfBothSidesAreTheFacesShareOfM) {
  const Prepared p(testing::white_noise({6, 6, 6}, 5));
  std::set<std::array<std::uint32_t, 2>> inside;
  std::set<std::array<std::uint32_t, 2>> outside;
  for (const Side side : {Side::inside, Side::outside})
    for (const std::uint32_t piece : all_pieces(p.complex(side)))
      for (const auto& [a, b] : p.complex(side).segments(piece))
        if (std::max(a, b) < p.surface.grid_edges.size())  // off the walls
          (side == Side::inside ? inside : outside).insert({std::min(a, b), std::max(a, b)});
  EXPECT_EQ(inside, outside);
  EXPECT_EQ(inside.size(), 2 * p.surface.grid_edges.size()) << "four segments meet at each vertex";
}

}  // namespace
}  // namespace isoloop
