#include "core/scan/scan.h"

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "core/base/errors.h"
#include "core/base/threads.h"
#include "tests/oracles/random_volumes.h"
#include "tests/oracles/scan_comparison.h"
#include "tests/samples/real_data.h"

namespace isoloop {
namespace {

using testing::differences;
using testing::numbers;
using testing::SmallVolume;

/// Values of the volume, some between them and some beyond.
std::vector<double> isos_for(const SmallVolume& volume, std::size_t most) {
  std::set<double> values(volume.values.begin(), volume.values.end());
  std::set<double> isos = values;
  for (auto at = values.begin(); at != values.end() && std::next(at) != values.end(); ++at)
    isos.insert((*at + *std::next(at)) / 2);
  isos.insert(*isos.begin() - 1);
  isos.insert(*isos.rbegin() + 1);
  std::vector<double> all(isos.begin(), isos.end());
  if (all.size() <= most) return all;
  std::vector<double> few;
  for (std::size_t i = 0; i < most; ++i) few.push_back(all[i * all.size() / most]);
  return few;
}

void expect_equal_to_count(int volumes, const std::function<SmallVolume(std::uint32_t)>& make) {
  std::atomic<int> different = 0;
  tbb::parallel_for(0, volumes, [&](int i) {
    const SmallVolume volume = make(static_cast<std::uint32_t>(i));
    const auto isos = isos_for(volume, 24);
    for (const InsideRule inside : {InsideRule::above, InsideRule::below})
      for (const Topology topology : {Topology::trilinear, Topology::simple})
        if (!differences(volume.view(), isos, inside, topology).empty()) ++different;
  });
  EXPECT_EQ(different, 0);
}

SmallVolume integers(const Index3& dims, std::uint32_t seed, std::uint32_t kinds) {
  SmallVolume volume = testing::white_noise(dims, seed);
  std::mt19937 random(seed);
  for (double& value : volume.values) value = static_cast<double>(random() % kinds);
  return volume;
}

TEST(Scan, EqualsCountOnWhiteNoise) {
  expect_equal_to_count(1000, [](std::uint32_t i) { return testing::white_noise({4, 4, 4}, i); });
}

TEST(Scan, EqualsCountWhereValuesTie) {
  expect_equal_to_count(1000, [](std::uint32_t i) { return integers({4, 3, 4}, i, 2 + i % 6); });
}

TEST(Scan, EqualsCountWhereTheSolidIsAtTheIsoValue) {
  // Saturated voxels: six at the iso value round a diagonal join its ends outside.
  expect_equal_to_count(300, [](std::uint32_t i) {
    SmallVolume volume = testing::white_noise({4, 4, 4}, i);
    for (double& value : volume.values) value = value > -0.4 ? 255 : value > -0.7 ? 254 : 0;
    return volume;
  });
}

TEST(Scan, EqualsCountOnSmoothFields) {
  expect_equal_to_count(60, [](std::uint32_t i) { return testing::smooth_noise({9, 8, 7}, i, 1); });
}

TEST(Scan, EqualsCountOnOneVoxelAndOneRow) {
  expect_equal_to_count(20, [](std::uint32_t i) { return testing::white_noise({1, 1, 1}, i); });
  expect_equal_to_count(20, [](std::uint32_t i) { return testing::white_noise({6, 1, 1}, i); });
}

TEST(Scan, KnowsTheTunnelsWithinCubes) {
  // So that the two topologies are told apart by what the tests above compare.
  int different = 0;
  for (std::uint32_t i = 0; i < 50; ++i) {
    const SmallVolume volume = testing::white_noise({6, 6, 6}, i);
    const std::vector<double> isos{-0.2, 0.0, 0.2};
    const auto trilinear = scan_topology(volume.view(), isos, {.topology = Topology::trilinear});
    const auto simple = scan_topology(volume.view(), isos, {.topology = Topology::simple});
    for (std::size_t r = 0; r < isos.size(); ++r)
      different += trilinear[r].euler != simple[r].euler ? 1 : 0;
  }
  EXPECT_GT(different, 5);
}

TEST(Scan, InfiniteValuesAreVeryLargeOnes) {
  SmallVolume volume = testing::white_noise({4, 4, 4}, 3);
  volume.values[7] = std::numeric_limits<double>::infinity();
  volume.values[30] = -std::numeric_limits<double>::infinity();
  const std::vector<double> isos{-0.5, 0.0, 0.5};
  EXPECT_TRUE(differences(volume.view(), isos, InsideRule::above, Topology::trilinear).empty());
}

TEST(Scan, IsTheSameForAnyNumberOfThreads) {
  const SmallVolume volume = testing::white_noise({20, 20, 20}, 5);
  std::vector<double> isos;
  for (int i = -10; i <= 10; ++i) isos.push_back(0.09 * i);
  const auto scan = [&] { return scan_topology(volume.view(), isos); };
  const auto many = with_threads(16, scan);
  const auto few = with_threads(1, scan);
  for (std::size_t i = 0; i < isos.size(); ++i)
    EXPECT_EQ(numbers(many[i].betti, many[i].euler, many[i].inside_voxels),
              numbers(few[i].betti, few[i].euler, few[i].inside_voxels));
}

TEST(Scan, CountsComponentsAndCavitiesOfASize) {
  // A bar of four voxels, one of one voxel, and a shell round a hollow of one voxel.
  SmallVolume volume;
  volume.dims = {7, 5, 3};
  volume.values.assign(105, 0.0);
  for (const std::size_t x : {0U, 1U, 2U, 3U}) volume.values[x] = 2.0;
  volume.values[6] = 2.0;
  for (std::size_t z = 0; z < 3; ++z)
    for (std::size_t y = 2; y < 5; ++y)
      for (std::size_t x = 4; x < 7; ++x) volume.values[x + 7 * y + 35 * z] = 2.0;
  volume.values[5 + 7 * 3 + 35] = 0.0;
  const std::vector<double> isos{1.0, 3.0};
  const std::vector<std::int64_t> sizes{1, 2, 5};
  const SizedScan scan = scan_sizes(volume.view(), isos, sizes);
  EXPECT_EQ(scan.rows[0].betti.b0, 3);
  EXPECT_EQ(scan.large[0][0].b0, 3);
  EXPECT_EQ(scan.large[1][0].b0, 2);
  EXPECT_EQ(scan.large[2][0].b0, 1);
  EXPECT_EQ(scan.large[0][0].b2, 1);
  EXPECT_EQ(scan.large[1][0].b2, 0);
  EXPECT_EQ(scan.large[0][1].b0, 0);
  EXPECT_EQ(scan.large[2][1].b2, 0) << "what lies round the grid is no cavity";
  EXPECT_EQ(scan.largest, (std::vector<std::int64_t>{26, 0}));
  const SizedScan below = scan_sizes(volume.view(), isos, sizes, {.inside = InsideRule::below});
  EXPECT_EQ(below.large[2][1].b0, 1);
}

TEST(Scan, RefusesWhatMakesNoSense) {
  const SmallVolume volume = testing::white_noise({3, 3, 3}, 1);
  const auto scan = [&](const std::vector<double>& isos) { scan_topology(volume.view(), isos); };
  EXPECT_THROW(scan({}), InvalidArgument);
  EXPECT_THROW(scan({1.0, 1.0}), InvalidArgument);
  EXPECT_THROW(scan({std::nan("")}), InvalidArgument);
  SmallVolume damaged = volume;
  damaged.values[14] = std::nan("");
  const std::vector<double> isos{0.0};
  try {
    scan_topology(damaged.view(), isos);
    FAIL() << "accepted";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.fault, Fault::not_finite);
    EXPECT_EQ(error.finding.place, "voxel (2, 1, 1)");
  }
}

struct RealVolume {
  std::string name;
  Index3 dims;
  std::vector<double> isos;
};

class ScanOfRealVolumes : public ::testing::TestWithParam<RealVolume> {};

TEST_P(ScanOfRealVolumes, EqualsCount) {
  const RealVolume& real = GetParam();
  ISOLOOP_NEEDS("volumes/" + real.name);
  const std::vector<std::uint8_t> voxels = testing::bytes_of("volumes/" + real.name);
  const GridView<std::uint8_t> grid{voxels, real.dims, {1, 1, 1}};
  EXPECT_EQ(differences(grid, real.isos, InsideRule::above, Topology::trilinear),
            std::vector<double>());
  EXPECT_EQ(differences(grid, {real.isos[1]}, InsideRule::below, Topology::simple),
            std::vector<double>());
}

std::vector<double> every(int step) {
  std::vector<double> isos;
  for (int iso = 0; iso <= 255; iso += step) isos.push_back(iso);
  return isos;
}

INSTANTIATE_TEST_SUITE_P(
    All, ScanOfRealVolumes,
    ::testing::Values(
        RealVolume{"fuel_64x64x64_uint8.raw", {64, 64, 64}, every(3)},
        RealVolume{"silicium_98x34x34_uint8.raw", {98, 34, 34}, every(3)},
        RealVolume{"engine_256x256x128_uint8.raw", {256, 256, 128}, {60, 70, 80, 100, 180.5}},
        RealVolume{"aneurism_256x256x256_uint8.raw", {256, 256, 256}, {51, 100, 200}}),
    [](const auto& tested) { return testing::short_name(tested.param.name); });

}  // namespace
}  // namespace isoloop
