#include "core/octree/leaves.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <tbb/parallel_for.h>

namespace isoloop {
namespace {

constexpr std::uint32_t least_largest = 3;  // heights
constexpr std::uint32_t most_largest = 5;

/// Leaves of this height are a few dozen along the box's longest side.
std::uint32_t largest_height(const std::array<std::uint32_t, 3>& cubes) {
  std::uint32_t height = least_largest;
  const std::uint32_t longest = *std::max_element(cubes.begin(), cubes.end());
  while (height < most_largest && longest >> height > 48) ++height;
  return height;
}

/// The blocks of height 1 that M crosses.
BlockBits crossed_pairs(const VoxelSides& sides, const std::array<std::uint32_t, 3>& cubes) {
  BlockBits crossed({(cubes[0] + 1) / 2, (cubes[1] + 1) / 2, (cubes[2] + 1) / 2});
  tbb::parallel_for(std::uint32_t{0}, crossed.dims()[2], [&](std::uint32_t layer) {
    for (std::uint32_t z = 2 * layer; z < std::min(2 * layer + 2, cubes[2]); ++z)
      for (std::uint32_t y = 0; y < cubes[1]; ++y) {
        const std::uint8_t* const row = sides.cubes.data() + sides.lattice.vertex(0, y, z);
        for (std::uint32_t x = 0; x < cubes[0]; ++x)
          if ((row[x] & VoxelSides::is_cut) != 0) crossed.insert(x / 2, y / 2, layer);
      }
  });
  return crossed;
}

/// Blocks of a height that stick out of the box.
BlockBits not_within(const std::array<std::uint32_t, 3>& cubes, std::uint32_t height,
                     const std::array<std::uint32_t, 3>& dims) {
  BlockBits outside(dims);
  std::array<bool, 3> sticks_out{};
  for (std::size_t a = 0; a < 3; ++a) sticks_out[a] = dims[a] << height > cubes[a];
  for (std::uint32_t z = 0; z < dims[2]; ++z)
    for (std::uint32_t y = 0; y < dims[1]; ++y) {
      if ((sticks_out[1] && y + 1 == dims[1]) || (sticks_out[2] && z + 1 == dims[2]))
        for (std::uint32_t x = 0; x < dims[0]; ++x) outside.insert(x, y, z);
      if (sticks_out[0]) outside.insert(dims[0] - 1, y, z);
    }
  return outside;
}

/// Blocks along each axis that `grading` times a block's widest side comes to.
std::array<std::uint32_t, 3> steps_of(const Vec3& spacing, int grading) {
  constexpr double most = 16.0;  // farther, and hardly a block would be left
  const double widest = std::max({spacing[0], spacing[1], spacing[2]});
  std::array<std::uint32_t, 3> steps{};
  for (std::size_t a = 0; a < 3; ++a)
    steps[a] = static_cast<std::uint32_t>(
        std::min(most, std::ceil(grading * widest / spacing[a] * (1.0 - 1e-9))));
  return steps;
}

}  // namespace

Leaves graded_leaves(const VoxelSides& sides, const Vec3& spacing, int grading) {
  const auto& [nx, ny, nz] = sides.lattice.dims;
  Leaves leaves;
  leaves.cubes = {nx - 1, ny - 1, nz - 1};
  leaves.largest = largest_height(leaves.cubes);
  leaves.is_split.resize(leaves.largest + 1);
  const auto steps = steps_of(spacing, grading);
  BlockBits crossed = crossed_pairs(sides, leaves.cubes);
  for (std::uint32_t height = 1; height <= leaves.largest; ++height) {
    BlockBits& split = leaves.is_split[height];
    split = dilated(crossed, steps);
    split.insert(not_within(leaves.cubes, height, crossed.dims()));
    if (height > 1) split.insert(parents_of(dilated(leaves.is_split[height - 1], {1, 1, 1})));
    if (height < leaves.largest) crossed = parents_of(crossed);
  }
  return leaves;
}

std::uint64_t leaf_count(const Leaves& leaves) {
  std::atomic<std::uint64_t> count = 0;
  tbb::parallel_for(std::uint32_t{0}, leaves.is_split[leaves.largest].dims()[2],
                    [&](std::uint32_t layer) {
                      std::uint64_t here = 0;
                      for_each_leaf(leaves, layer, [&](const auto&, std::uint32_t) { ++here; });
                      count += here;
                    });
  return count;
}

}  // namespace isoloop
