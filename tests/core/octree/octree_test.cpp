#include "core/octree/octree.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "core/octree/leaves.h"
#include "tests/samples/octree_fixture.h"

namespace isoloop {
namespace {

using testing::Prepared;

struct Leaf {
  std::array<std::uint32_t, 3> first{};
  std::uint32_t height = 0;
};

std::vector<Leaf> all_leaves(const Leaves& leaves) {
  std::vector<Leaf> all;
  for (std::uint32_t layer = 0; layer < leaves.is_split[leaves.largest].dims()[2]; ++layer)
    for_each_leaf(leaves, layer,
                  [&](const std::array<std::uint32_t, 3>& first, std::uint32_t height) {
                    all.push_back({first, height});
                  });
  return all;
}

/// The height of the leaf that holds each cube, by its lowest corner; 255 where there is none.
std::vector<std::uint8_t> height_of_cube(const Lattice& lattice, const std::vector<Leaf>& leaves) {
  std::vector<std::uint8_t> heights(lattice.vertex_count(), 255);
  for (const auto& [first, height] : leaves)
    for (std::uint32_t z = 0; z < 1U << height; ++z)
      for (std::uint32_t y = 0; y < 1U << height; ++y)
        for (std::uint32_t x = 0; x < 1U << height; ++x) {
          std::uint8_t& at = heights[lattice.vertex(first[0] + x, first[1] + y, first[2] + z)];
          EXPECT_EQ(at, 255) << "two leaves hold one cube";
          at = static_cast<std::uint8_t>(height);
        }
  return heights;
}

/// How many blocks of a leaf's width lie between it and the nearest that M crosses; 9 where none
/// does so near.
int blocks_to_surface(const VoxelSides& sides, const Leaf& leaf) {
  const auto& dims = sides.lattice.dims;
  for (int distance = 0; distance < 3; ++distance) {
    const std::int64_t width = std::int64_t{1} << leaf.height;
    std::array<std::int64_t, 3> low{};
    std::array<std::int64_t, 3> high{};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::max<std::int64_t>(0, leaf.first[a] - distance * width);
      high[a] = std::min<std::int64_t>(dims[a] - 1, leaf.first[a] + (distance + 1) * width);
    }
    for (std::int64_t z = low[2]; z < high[2]; ++z)
      for (std::int64_t y = low[1]; y < high[1]; ++y)
        for (std::int64_t x = low[0]; x < high[0]; ++x)
          if ((sides.cubes[sides.lattice.vertex(static_cast<std::uint32_t>(x),
                                                static_cast<std::uint32_t>(y),
                                                static_cast<std::uint32_t>(z))] &
               VoxelSides::is_cut) != 0)
            return distance;
  }
  return 9;
}

TEST(Leaves, FillTheBoxAndKeepTheirDistanceFromTheSurface) {
  std::size_t large = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed)
    for (int grading = 0; grading < 3; ++grading) {
      const Prepared p(testing::with_room(seed));
      if (p.surface.points.empty()) continue;
      const Leaves leaves = graded_leaves(p.sides, p.surface.spacing, grading);
      const std::vector<Leaf> all = all_leaves(leaves);
      ASSERT_EQ(all.size(), leaf_count(leaves));
      const auto height_at = height_of_cube(p.sides.lattice, all);
      std::uint64_t held = 0;
      for (const Leaf& leaf : all) {
        held += std::uint64_t{1} << (3 * leaf.height);
        large += leaf.height > 1 ? 1 : 0;
        if (leaf.height > 0) {
          ASSERT_GT(blocks_to_surface(p.sides, leaf), grading);
        }
      }
      const auto& [nx, ny, nz] = leaves.cubes;
      ASSERT_EQ(held, std::uint64_t{nx} * ny * nz);
      // Leaves that touch, in a corner too, differ by one height at most.
      for (std::uint32_t z = 0; z < nz; ++z)
        for (std::uint32_t y = 0; y < ny; ++y)
          for (std::uint32_t x = 0; x < nx; ++x)
            for (std::uint32_t c = 1; c < 8; ++c) {
              const std::array<std::uint32_t, 3> to{x + (c & 1U), y + (c >> 1 & 1U), z + (c >> 2)};
              if (to[0] >= nx || to[1] >= ny || to[2] >= nz) continue;
              const int here = height_at[p.sides.lattice.vertex(x, y, z)];
              const int there = height_at[p.sides.lattice.vertex(to[0], to[1], to[2])];
              ASSERT_LE(std::abs(here - there), 1);
            }
    }
  EXPECT_GT(large, 1000U);
}

TEST(Leaves, KeepTheirDistanceInUnitsOfLengthWhereVoxelsAreFlat) {
  const Prepared p(testing::with_room(2));
  const auto count = [&](const Vec3& spacing) {
    return leaf_count(graded_leaves(p.sides, spacing, 1));
  };
  EXPECT_LT(count({1.0, 1.0, 1.0}), count({1.0, 1.0, 3.0}));
  EXPECT_EQ(count({1.0, 1.0, 1.0}), count({7.0, 7.0, 7.0}));
}

TEST(Octree, FindsTheLeafOfEveryCube) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const Prepared p(testing::with_room(seed));
    if (p.surface.points.empty()) continue;
    const testing::PreparedOctree made(p, static_cast<int>(seed % 3));
    const Octree& octree = made.octree;
    std::uint32_t leaves = 0;
    for (std::uint32_t v = 0; v < octree.vertex_count(); ++v) {
      const std::uint32_t at = octree.lattice_vertex(v);
      ASSERT_EQ(octree.vertex_at(at), v);
      ASSERT_EQ(octree.is_inside(v), p.sides.is_on(Side::inside, at));
      const std::uint32_t height = octree.leaf_height(v);
      if (height == Octree::none) continue;
      ++leaves;
      for (std::uint32_t z = 0; z < 1U << height; ++z)
        for (std::uint32_t y = 0; y < 1U << height; ++y)
          for (std::uint32_t x = 0; x < 1U << height; ++x) {
            const auto& stride = p.sides.lattice.stride;
            const std::uint32_t cube = at + x + y * stride[1] + z * stride[2];
            ASSERT_EQ(octree.leaf_at(cube), v);
            ASSERT_EQ(octree.leaf_at(cube, height), v);
          }
    }
    EXPECT_EQ(leaves, octree.leaf_count());
  }
}

}  // namespace
}  // namespace isoloop
