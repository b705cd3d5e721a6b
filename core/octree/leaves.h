// Which blocks of cubes are the leaves of the octree: single cubes where M passes, larger blocks
// the farther from it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/cube/voxel_sides.h"
#include "core/grid/vec3.h"
#include "core/octree/block_bits.h"

namespace isoloop {

inline constexpr int max_grading = 2;

/// A block of height l is 2^l cubes wide, and its lowest corner is a multiple of that.
struct Leaves {
  std::array<std::uint32_t, 3> cubes{};  // of the box, by axis
  std::uint32_t largest = 0;             // height
  std::vector<BlockBits> is_split;       // by height, from 1 on: blocks that are no leaves

  bool is_leaf(std::uint32_t height, const std::array<std::uint32_t, 3>& block) const {
    return height == 0 || !is_split[height](block[0], block[1], block[2]);
  }
};

/// A block is a leaf if it lies within the box and M crosses no block of its height within
/// `grading` times the width of the widest side of such a block, and if leaves that touch it are at
/// most twice as wide or half as wide. `spacing`: of the voxels. Grading 0 to max_grading; 0: M
/// does not cross it.
Leaves graded_leaves(const VoxelSides& sides, const Vec3& spacing, int grading);

/// Calls visit(position of the lowest corner, height) for the leaves within one layer of the
/// largest blocks.
template <class Visit>
void for_each_leaf(const Leaves& leaves, std::uint32_t layer, const Visit& visit) {
  const auto descend = [&](const auto& self, std::uint32_t height,
                           const std::array<std::uint32_t, 3>& block) -> void {
    if (leaves.is_leaf(height, block)) {
      visit(
          std::array<std::uint32_t, 3>{block[0] << height, block[1] << height, block[2] << height},
          height);
      return;
    }
    for (std::uint32_t child = 0; child < 8; ++child) {
      const std::array<std::uint32_t, 3> part{2 * block[0] + (child & 1U),
                                              2 * block[1] + (child >> 1 & 1U),
                                              2 * block[2] + (child >> 2)};
      bool within = true;
      for (std::size_t a = 0; a < 3; ++a)
        within = within && part[a] << (height - 1) < leaves.cubes[a];
      if (within) self(self, height - 1, part);
    }
  };
  const auto& dims = leaves.is_split[leaves.largest].dims();
  for (std::uint32_t y = 0; y < dims[1]; ++y)
    for (std::uint32_t x = 0; x < dims[0]; ++x) descend(descend, leaves.largest, {x, y, layer});
}

std::uint64_t leaf_count(const Leaves& leaves);

}  // namespace isoloop
