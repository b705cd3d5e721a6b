// Repairs at size: ten thousand random volumes, every loop of real ones. Minutes to an hour of CPU,
// so not among the tests that run by default.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "core/repair/repair.h"
#include "core/repair/repair_round.h"
#include "tests/oracles/random_volumes.h"
#include "tests/samples/real_data.h"
#include "volume/files/read.h"
#include "volume/shapes/shapes.h"

namespace isoloop {
namespace {

/// Of 10 000 volumes.
struct Tally {
  std::atomic<std::int64_t> removals = 0;
  std::atomic<std::int64_t> voxels = 0;
  std::atomic<std::int64_t> kept = 0;  // handles that no change was found for
};

/// Removes all loops that can be removed, and counts anew whatever the repair says of itself.
void expect_no_loops_left(std::uint32_t seed, Tally& tally) {
  testing::SmallVolume volume = testing::noise_of_some_size(seed);
  const IsoLevel level{0.0};
  const Repair repair = repair_loops(volume.view(), level, {.genus = 0, .keep_going = true});
  const Analysis before = count_topology(volume.view(), level);
  // Only the values that were reported change: all others keep their bits.
  for (const VoxelChange& change : repair.changes) volume.values[change.voxel] = change.after;
  const Analysis after = count_topology(volume.view(), level);
  const auto removals = static_cast<std::int64_t>(repair.removals.size());
  tally.removals += removals;
  tally.voxels += static_cast<std::int64_t>(repair.changes.size());
  tally.kept += after.surface.genus();
  EXPECT_EQ(after.surface.genus(), before.surface.genus() - removals) << "volume " << seed;
  EXPECT_EQ(after.betti.b0, before.betti.b0) << "volume " << seed;
  EXPECT_EQ(after.betti.b2, before.betti.b2) << "volume " << seed;
  EXPECT_EQ(repair.kept.empty(), after.surface.genus() == 0) << "volume " << seed;
}

TEST(RepairSlow, ReachesGenusZeroOnTenThousandVolumesButForOneLoopInTenThousand) {
  Tally tally;
  tbb::parallel_for(std::uint32_t{0}, std::uint32_t{10'000},
                    [&](std::uint32_t seed) { expect_no_loops_left(seed, tally); });
  std::printf("10000 volumes: %lld loops removed, %lld kept, %lld voxels changed\n",
              static_cast<long long>(tally.removals), static_cast<long long>(tally.kept),
              static_cast<long long>(tally.voxels));
  EXPECT_LE(tally.kept * 10'000, tally.removals);
}

/// Area that the loop spans, by the normals of its curves; units of length squared.
double cross_section(const Surface& surface, const Loop& loop) {
  double area = 0.0;
  for (const Curve& curve : loop.curves) {
    Vec3 normal{};
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vec3 p = scaled_point(surface, curve[i]);
      const Vec3 q = scaled_point(surface, curve[(i + 1) % curve.size()]);
      for (std::size_t a = 0; a < 3; ++a)
        normal[a] += (p[(a + 1) % 3] * q[(a + 2) % 3] - p[(a + 2) % 3] * q[(a + 1) % 3]) / 2;
    }
    area += std::hypot(normal[0], normal[1], normal[2]);
  }
  return area;
}

/// Every loop removed from the volume as it came; voxels per cross-section of each tunnel.
std::vector<double> remove_each(const AnyGridView& grid, const IsoLevel& level,
                                const std::string& name) {
  VoxelValues values(grid);
  const Workings workings = work_out_loops(grid, level);
  const Analysis& analysis = workings.analysis;
  std::vector<double> ratios;
  int across = 0;
  for (std::size_t i = 0; i < analysis.loops.size(); ++i) {
    const Loop& loop = analysis.loops[i];
    RepairRound round(workings, level, values, 1);
    const bool is_removed = round.remove(round.all()[i], false, Effort::few_voxels) ||
                            round.remove(round.all()[i], false, Effort::membranes) ||
                            round.remove(round.all()[i], false, Effort::any);
    if (!is_removed) {
      ADD_FAILURE() << name << ": " << name_of(loop.kind) << " " << loop.id;
      continue;
    }
    const Done done = round.finish().done.at(0);
    const Analysis after = count_topology(values.view(), level);
    for (const VoxelChange& voxel : done.changes) values.set(voxel.voxel, voxel.before);
    EXPECT_EQ(after.surface.genus(), analysis.surface.genus() - 1) << name << loop.id;
    EXPECT_EQ(after.betti.b0, analysis.betti.b0) << name << loop.id;
    EXPECT_EQ(after.betti.b2, analysis.betti.b2) << name << loop.id;
    if (done.removal.by.kind != loop.kind)
      ++across;
    else if (loop.kind == LoopKind::tunnel)
      ratios.push_back(static_cast<double>(done.changes.size()) /
                       cross_section(analysis.surface, loop));
  }
  std::sort(ratios.begin(), ratios.end());
  std::printf(
      "%s: %d loops removed one by one, %d of them across; voxels per cross-section of a "
      "tunnel: median %.2f\n",
      name.c_str(), static_cast<int>(analysis.loops.size()), across,
      ratios.empty() ? 0.0 : ratios[ratios.size() / 2]);
  std::fflush(stdout);
  return ratios;
}

TEST(RepairSlow, RemovesEveryLoopOfEveryShape) {
  for (const std::string& name : shape_names()) {
    const Shape shape = make_shape(name, {.size = minimum_shape_size(name)});
    remove_each(view(shape.volume), shape.level, name);
  }
}

struct RealVolume {
  std::string file;
  double iso;
};

class RealVolumes : public ::testing::TestWithParam<RealVolume> {};

TEST_P(RealVolumes, LoseEveryLoopOneByOne) {
  ISOLOOP_NEEDS("volumes/" + GetParam().file);
  const Volume volume = read_volume(testing::data("volumes/" + GetParam().file));
  const auto ratios = remove_each(view(volume), {GetParam().iso}, GetParam().file);
  if (!ratios.empty()) {
    EXPECT_LE(ratios[ratios.size() / 2], 3.0);
  }
}

INSTANTIATE_TEST_SUITE_P(RepairSlow, RealVolumes,
                         ::testing::Values(RealVolume{"fuel_64x64x64_uint8.raw", 15},
                                           RealVolume{"silicium_98x34x34_uint8.raw", 85},
                                           RealVolume{"hydrogen_128x128x128_uint8.raw", 15},
                                           RealVolume{"engine_256x256x128_uint8.raw", 70},
                                           RealVolume{"aneurism_256x256x256_uint8.raw", 100}),
                         [](const auto& tested) { return testing::short_name(tested.param.file); });

TEST(RepairSlow, FillsExactlyTheShortTunnelsOfEngine) {
  const std::string name = "volumes/engine_256x256x128_uint8.raw";
  ISOLOOP_NEEDS(name);
  const Volume volume = read_volume(testing::data(name));
  const Repair repair = repair_loops(view(volume), {70}, {.fill_tunnels = 30.0});
  const auto tunnels = [](const Analysis& analysis, double below) {
    return std::count_if(analysis.loops.begin(), analysis.loops.end(), [&](const Loop& loop) {
      return loop.kind == LoopKind::tunnel && loop.length < below;
    });
  };
  const auto short_tunnels = tunnels(repair.before, 30.0);
  EXPECT_GT(short_tunnels, 0);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(repair.removals.size()), short_tunnels);
  EXPECT_EQ(tunnels(repair.after, 30.0), 0);
  EXPECT_EQ(tunnels(repair.after, 1e9), tunnels(repair.before, 1e9) - short_tunnels);
  EXPECT_EQ(repair.removed_voxels, 0);
}

}  // namespace
}  // namespace isoloop
