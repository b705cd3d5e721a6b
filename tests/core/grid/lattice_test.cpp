#include "core/grid/lattice.h"

#include <gtest/gtest.h>

namespace isoloop {
namespace {

TEST(Lattice, NumbersItsVerticesInScanOrder) {
  const Lattice lattice = make_lattice({-1, -1, -1}, {4, 3, 5});
  std::uint32_t expected = 0;
  for (std::uint32_t z = 0; z < 5; ++z)
    for (std::uint32_t y = 0; y < 3; ++y)
      for (std::uint32_t x = 0; x < 4; ++x, ++expected) {
        EXPECT_EQ(lattice.vertex(x, y, z), expected);
        EXPECT_EQ(lattice.position(expected), (std::array<std::uint32_t, 3>{x, y, z}));
      }
  EXPECT_EQ(lattice.vertex_count(), expected);
}

TEST(Lattice, StridesLeadToTheNextVertexAlongEachAxis) {
  const Lattice lattice = make_lattice({0, 0, 0}, {4, 3, 5});
  const std::uint32_t vertex = lattice.vertex(1, 1, 1);
  EXPECT_EQ(vertex + lattice.stride[0], lattice.vertex(2, 1, 1));
  EXPECT_EQ(vertex + lattice.stride[1], lattice.vertex(1, 2, 1));
  EXPECT_EQ(vertex + lattice.stride[2], lattice.vertex(1, 1, 2));
}

TEST(Lattice, LargestOneNumbersItsEdgesInThirtyTwoBits) {
  EXPECT_LE(3 * max_lattice_vertices + 2, std::uint64_t{0xFFFF'FFFF});
}

TEST(Lattice, CrossAxesTurnRightHanded) {
  EXPECT_EQ(cross_axes(0), (std::array<int, 2>{1, 2}));
  EXPECT_EQ(cross_axes(1), (std::array<int, 2>{2, 0}));
  EXPECT_EQ(cross_axes(2), (std::array<int, 2>{0, 1}));
}

}  // namespace
}  // namespace isoloop
