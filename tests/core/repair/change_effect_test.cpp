#include "core/repair/change_effect.h"

#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "tests/oracles/tied_volumes.h"

namespace isoloop {
namespace {

struct WholeCounts {
  std::int64_t euler = 0;
  std::int64_t inside_parts = 0;
  std::int64_t outside_parts = 0;
};

WholeCounts count_all(const AnyGridView& grid, const IsoLevel& level) {
  const Analysis counted = count_topology(grid, level);
  return {counted.surface.euler(), counted.betti.b0, counted.betti.b2 + 1};
}

/// One to four voxels in a small box, which often cross sides.
std::vector<VoxelChange> random_change(const Lattice& lattice, const VoxelValues& values,
                                       std::mt19937& random) {
  const Index3& dims = values.dims();
  std::set<std::size_t> voxels;
  const Index3 near = lattice.voxel_at(random() % lattice.vertex_count());
  for (unsigned n = 1 + random() % 4; n > 0; --n) {
    Index3 at = near;
    for (std::int64_t& i : at) i += static_cast<std::int64_t>(random() % 3);
    bool is_in_grid = lattice.vertex_at(at).has_value();
    for (std::size_t a = 0; a < 3; ++a) is_in_grid = is_in_grid && at[a] >= 0 && at[a] < dims[a];
    if (is_in_grid)
      voxels.insert(static_cast<std::size_t>(at[0] + dims[0] * (at[1] + dims[1] * at[2])));
  }
  std::vector<VoxelChange> change;
  change.reserve(voxels.size());
  for (const std::size_t voxel : voxels)
    change.push_back({voxel, values.at(voxel), 38.0 + random() % 5});
  return change;
}

TEST(ChangeEffect, IsTheDifferenceOfWholeCountsOnRandomVolumesWithTies) {
  std::size_t changes = 0;
  std::size_t across = 0;  // changes that join or part something
  for (std::uint32_t seed = 0; seed < 4000; ++seed) {
    const testing::TiedVolume volume = testing::tied_volume(seed);
    const VoxelSides sides = classify(volume.view(), volume.level);
    if (sides.empty()) continue;
    VoxelValues values(volume.view());
    CurrentVolume current(sides, volume.level, values);
    PartSearch search(current);
    std::mt19937 random(seed);
    WholeCounts now = count_all(values.view(), volume.level);
    for (int step = 0; step < 6; ++step) {
      const auto change = random_change(sides.lattice, values, random);
      if (change.empty()) continue;
      const ChangeEffect effect = effect_of(change, current, search);
      const WholeCounts unchanged = count_all(values.view(), volume.level);
      ASSERT_EQ(unchanged.euler, now.euler) << "the voxels are left as they were";
      for (const VoxelChange& voxel : change) current.set(voxel.voxel, voxel.after);
      const WholeCounts next = count_all(values.view(), volume.level);
      ASSERT_EQ(effect, (ChangeEffect{next.euler - now.euler, next.inside_parts - now.inside_parts,
                                      next.outside_parts - now.outside_parts}))
          << "seed " << seed << ", change " << step;
      ++changes;
      across += effect.inside_parts != 0 || effect.outside_parts != 0 ? 1 : 0;
      now = next;
    }
  }
  EXPECT_GT(changes, 10'000U);
  EXPECT_GT(across, 1000U);
}

}  // namespace
}  // namespace isoloop
