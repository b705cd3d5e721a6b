#include "core/analysis/analysis.h"

#include <mutex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/base/threads.h"
#include "tests/oracles/random_volumes.h"
#include "tests/samples/core_fixture.h"
#include "tests/samples/real_data.h"

namespace isoloop {
namespace {

using testing::SmallVolume;
using testing::zero_level;

/// All that a report is made of, to the bit.
std::string fingerprint(const Analysis& analysis) {
  std::string bytes;
  const auto put = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const auto& point : analysis.surface.points) put(point);
  for (const auto& triangle : analysis.surface.triangles) put(triangle);
  for (const Loop& loop : analysis.loops) {
    put(loop.id);
    put(loop.size);
    put(loop.length);
    put(loop.center_index);
    for (const Curve& curve : loop.curves)
      for (const std::uint32_t v : curve) put(v);
  }
  return bytes;
}

TEST(Analysis, SameBytesForAnyNumberOfThreads) {
  const SmallVolume volume = testing::smooth_noise({40, 41, 42}, 8, 2);
  std::set<std::string> results;
  for (const int threads : {1, 2, 4, 16, 2})
    results.insert(
        fingerprint(with_threads(threads, [&] { return analyze(volume.view(), zero_level); })));
  EXPECT_EQ(results.size(), 1U);
}

TEST(Analysis, AnEmptySurfaceHasNoLoops) {
  const SmallVolume volume{std::vector<double>(8, -1.0), {2, 2, 2}};
  const Analysis analysis = analyze(volume.view(), zero_level);
  EXPECT_TRUE(analysis.loops.empty());
  EXPECT_EQ(analysis.betti.b0, 0);
}

TEST(Analysis, AFullVolumeIsOneBall) {
  const SmallVolume volume{std::vector<double>(27, 1.0), {3, 3, 3}};
  const Analysis analysis = analyze(volume.view(), zero_level);
  EXPECT_TRUE(analysis.loops.empty());
  EXPECT_EQ(analysis.betti.b0, 1);
  EXPECT_EQ(analysis.betti.b1, 0);
}

TEST(Analysis, AxesOfOneVoxelWork) {
  const SmallVolume ring{{1, 1, 1, 1, -1, 1, 1, 1, 1}, {3, 3, 1}};
  const Analysis analysis = analyze(ring.view(), zero_level);
  EXPECT_EQ(analysis.betti.b1, 1);
  EXPECT_EQ(analysis.loops.size(), 2U);
  const SmallVolume rod{{1, 1, 1}, {1, 3, 1}};
  EXPECT_TRUE(analyze(rod.view(), zero_level).loops.empty());
}

TEST(Analysis, LengthsScaleWithTheSpacing) {
  const SmallVolume volume = testing::torus({24, 24, 24});
  GridView<double> doubled = volume.view();
  doubled.spacing = {2, 2, 2};
  const Analysis one = analyze(volume.view(), zero_level);
  const Analysis two = analyze(doubled, zero_level);
  ASSERT_EQ(one.loops.size(), two.loops.size());
  for (std::size_t i = 0; i < one.loops.size(); ++i) {
    EXPECT_NEAR(two.loops[i].length, 2 * one.loops[i].length, 1e-3);
    EXPECT_NEAR(two.loops[i].center_index[0], one.loops[i].center_index[0], 1e-4);
  }
}

TEST(Analysis, ExactSizesGiveAsManyLoops) {
  const SmallVolume volume = testing::smooth_noise({20, 20, 20}, 11, 2);
  AnalysisOptions exact;
  exact.geodesic = GeodesicMode::exact;
  EXPECT_EQ(analyze(volume.view(), zero_level, exact).loops.size(),
            analyze(volume.view(), zero_level).loops.size());
}

TEST(Analysis, TellsOfEveryStageOnce) {
  std::mutex mutex;
  std::vector<std::string> stages;
  AnalysisOptions options;
  options.progress = [&](const char* stage, double share) {
    const std::lock_guard lock(mutex);
    EXPECT_GE(share, 0.0);
    EXPECT_LE(share, 1.0);
    stages.emplace_back(stage);
  };
  const SmallVolume volume = testing::torus({16, 16, 16});
  analyze(volume.view(), zero_level, options);
  EXPECT_EQ(stages, (std::vector<std::string>{"surface", "closest", "sizes", "pass", "loops"}));
}

TEST(Analysis, LosesNoLoopOfWhiteNoise) {
  const SmallVolume volume = testing::white_noise({28, 28, 28}, 1);
  const Analysis analysis = analyze(volume.view(), zero_level);
  EXPECT_GT(analysis.surface.genus(), 1'000);
  EXPECT_EQ(static_cast<std::int64_t>(analysis.loops.size()), 2 * analysis.surface.genus());
}

struct KnownVolume {
  std::string file;
  Index3 dims;
  double iso;
  std::int64_t vertices, discs, euler, components, genus, b0, cavities;
  std::vector<Topology> topologies{Topology::trilinear, Topology::simple};
};

/// "engine_256_at_70", and the topology where there is one alone.
std::string name_of(const ::testing::TestParamInfo<KnownVolume>& tested) {
  const KnownVolume& known = tested.param;
  std::string name =
      testing::short_name(known.file) + "_at_" + std::to_string(static_cast<int>(known.iso));
  if (known.topologies.size() == 1)
    name += known.topologies.front() == Topology::simple ? "_simple" : "_trilinear";
  return name;
}

class RealVolume : public ::testing::TestWithParam<KnownVolume> {};

TEST_P(RealVolume, HasTheIndependentCount) {
  const KnownVolume& known = GetParam();
  ISOLOOP_NEEDS("volumes/" + known.file);
  const std::vector<std::uint8_t> values = testing::bytes_of("volumes/" + known.file);
  for (const Topology topology : known.topologies) {
    const Analysis analysis = count_topology(GridView<std::uint8_t>{values, known.dims, {1, 1, 1}},
                                             IsoLevel{known.iso, InsideRule::above, topology});
    EXPECT_EQ(static_cast<std::int64_t>(analysis.surface.points.size()), known.vertices);
    EXPECT_EQ(analysis.surface.polygons, known.discs);
    EXPECT_EQ(analysis.surface.euler(), known.euler);
    EXPECT_EQ(static_cast<std::int64_t>(analysis.surface.components.size()), known.components);
    EXPECT_EQ(analysis.surface.genus(), known.genus);
    EXPECT_EQ(analysis.betti.b0, known.b0);
    EXPECT_EQ(analysis.betti.b1, known.genus);
    EXPECT_EQ(analysis.betti.b2, known.cavities);
  }
}

const Index3 engine{256, 256, 128};
const Index3 engine_half{128, 128, 64};
const Index3 aneurism{256, 256, 256};
const std::vector<Topology> simple{Topology::simple};
const std::vector<Topology> trilinear{Topology::trilinear};

INSTANTIATE_TEST_SUITE_P(
    Table, RealVolume,
    ::testing::Values(
        KnownVolume{"engine_256x256x128_uint8.raw", engine, 60, 308290, 308252, -38, 1, 20, 1, 0},
        KnownVolume{"engine_256x256x128_uint8.raw", engine, 70, 309342, 309304, -38, 1, 20, 1, 0},
        KnownVolume{"engine_256x256x128_uint8.raw", engine, 80, 310718, 310680, -38, 1, 20, 1, 0},
        KnownVolume{"engine_256x256x128_uint8.raw", engine, 100, 316662, 316618, -44, 1, 23, 1, 0},
        KnownVolume{"engine_half_128x128x64_uint8.raw", engine_half, 60, 76394, 76356, -38, 1, 20,
                    1, 0},
        KnownVolume{"engine_half_128x128x64_uint8.raw", engine_half, 70, 76906, 76868, -38, 1, 20,
                    1, 0},
        KnownVolume{"engine_half_128x128x64_uint8.raw", engine_half, 80, 77146, 77108, -38, 1, 20,
                    1, 0},
        KnownVolume{"aneurism_256x256x256_uint8.raw", aneurism, 51, 126248, 129442, 3194, 1775, 178,
                    1749, 26, simple},
        KnownVolume{"aneurism_256x256x256_uint8.raw", aneurism, 51, 126311, 129400, 3152, 1769, 193,
                    1743, 26, trilinear},
        KnownVolume{"aneurism_256x256x256_uint8.raw", aneurism, 100, 88462, 90064, 1602, 865, 64,
                    861, 4, simple},
        KnownVolume{"aneurism_256x256x256_uint8.raw", aneurism, 100, 88492, 90044, 1582, 861, 70,
                    857, 4, trilinear},
        KnownVolume{
            "hydrogen_128x128x128_uint8.raw", {128, 128, 128}, 15, 29874, 29880, 6, 4, 1, 4, 0},
        KnownVolume{"fuel_64x64x64_uint8.raw", {64, 64, 64}, 15, 5316, 5302, -14, 1, 8, 1, 0},
        KnownVolume{"neghip_64x64x64_uint8.raw", {64, 64, 64}, 55, 15136, 15160, 24, 15, 3, 15, 0},
        KnownVolume{"nucleon_41x41x41_uint8.raw", {41, 41, 41}, 140, 3500, 3504, 4, 2, 0, 1, 1},
        KnownVolume{
            "silicium_98x34x34_uint8.raw", {98, 34, 34}, 85, 20024, 20036, 12, 37, 31, 1, 36}),
    name_of);

}  // namespace
}  // namespace isoloop
