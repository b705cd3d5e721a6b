// Promises that hold where M ends at the border of the grid.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "core/analysis/analysis.h"
#include "core/base/errors.h"
#include "tests/oracles/explicit_complex.h"
#include "tests/oracles/pair_comparison.h"
#include "tests/oracles/slow_killing.h"
#include "tests/oracles/slow_reduction.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using oracle::ExplicitComplex;
using testing::Prepared;
using testing::SidedPiece;
using testing::SmallVolume;

AnalysisOptions open_options(Engine engine = Engine::dual) {
  AnalysisOptions options;
  options.boundary = Boundary::open;
  options.engine = engine;
  return options;
}

Analysis open_loops(const SmallVolume& volume, Engine engine) {
  return analyze(volume.view(), testing::zero_level, open_options(engine));
}

SmallVolume noise(std::uint32_t i, std::int64_t most) {
  const std::int64_t span = most - 1;
  const Index3 dims{2 + i % span, 2 + i / 5 % span, 2 + i / 23 % span};
  return i % 3 == 0 ? testing::smooth_noise(dims, i, 1) : testing::white_noise(dims, i);
}

SmallVolume sampled(const Index3& dims, const std::function<double(const Vec3&)>& value) {
  SmallVolume volume{{}, dims};
  for (std::int64_t z = 0; z < dims[2]; ++z)
    for (std::int64_t y = 0; y < dims[1]; ++y)
      for (std::int64_t x = 0; x < dims[0]; ++x)
        volume.values.push_back(
            value({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}));
  return volume;
}

/// A ring of radius 7, as thick as a tube of radius 2.6, round an axis along z.
SmallVolume ring(const Index3& dims, const Vec3& center) {
  return sampled(dims, [&](const Vec3& p) {
    const double radial = std::hypot(p[0] - center[0], p[1] - center[1]) - 7.0;
    return 2.6 - std::hypot(radial, p[2] - center[2]);
  });
}

/// A plate that runs through the box along x and y, with round holes through it.
SmallVolume plate(const std::vector<std::array<double, 2>>& holes) {
  return sampled({24, 24, 9}, [&](const Vec3& p) {
    double inside = 2.1 - std::abs(p[2] - 4.03);
    for (const auto& [x, y] : holes)
      inside = std::min(inside, std::hypot(p[0] - x, p[1] - y) - 3.2);
    return inside;
  });
}

/// A pipe through the box along z.
SmallVolume pipe(double outer, double inner) {
  return sampled({20, 20, 12}, [&](const Vec3& p) {
    const double r = std::hypot(p[0] - 9.53, p[1] - 9.41);
    return std::min(outer - r, r - inner);
  });
}

struct Known {
  std::string name;
  SmallVolume volume;
  std::int64_t components, loops, genus, borders;
};

std::vector<Known> known_volumes() {
  const Index3 flat{24, 24, 13};
  return {
      {"a torus cut open by the border", ring(flat, {3.1, 11.6, 6.1}), 1, 1, 0, 2},
      {"a torus cut along its ring", ring({24, 24, 8}, {11.6, 11.4, 0.3}), 1, 1, 0, 2},
      {"a torus that touches the border", ring(flat, {8.6, 11.6, 6.1}), 1, 2, 1, 1},
      {"a torus within the box", ring({25, 25, 13}, {12.1, 11.6, 6.1}), 1, 2, 1, 0},
      {"a plate with two holes", plate({{7.1, 7.4}, {16.2, 15.3}}), 1, 3, 1, 2},
      {"a plate with a hole on the border", plate({{0.3, 12.2}}), 1, 0, 0, 1},
      {"a plate with two holes and one on the border",
       plate({{8.1, 6.4}, {16.2, 15.3}, {0.3, 12.2}}), 1, 4, 2, 1},
      {"a plate without a hole", plate({}), 2, 0, 0, 2},
      {"a rod through the box", pipe(5.2, -1.0), 1, 1, 0, 2},
      {"a tube through the box", pipe(7.2, 4.1), 2, 2, 0, 4},
  };
}

TEST(OpenBoundary, CountsTheLoopsOfKnownShapes) {
  for (const Known& known : known_volumes())
    for (const Engine engine : {Engine::dual, Engine::pair}) {
      const Analysis analysis = open_loops(known.volume, engine);
      EXPECT_EQ(analysis.betti.b0, known.components) << known.name;
      EXPECT_EQ(analysis.betti.b1, known.loops) << known.name;
      EXPECT_EQ(analysis.surface.genus(), known.genus) << known.name;
      std::int64_t borders = 0;
      for (const SurfaceComponent& part : analysis.surface.components) borders += part.borders;
      EXPECT_EQ(borders, known.borders) << known.name;
      ASSERT_EQ(static_cast<std::int64_t>(analysis.loops.size()), known.loops) << known.name;
      for (const Loop& loop : analysis.loops) {
        EXPECT_EQ(loop.kind, LoopKind::loop);
        EXPECT_TRUE(loop.certificate.nontrivial_on_surface);
        EXPECT_FALSE(loop.certificate.trivial_inside || loop.certificate.trivial_outside);
      }
    }
}

TEST(OpenBoundary, LoopOfARodGoesRoundIt) {
  for (const Engine engine : {Engine::dual, Engine::pair}) {
    const Analysis analysis = open_loops(pipe(5.2, -1.0), engine);
    ASSERT_EQ(analysis.loops.size(), 1U);
    EXPECT_NEAR(analysis.loops[0].length, 2 * 3.1416 * 5.2, 3.0);
    EXPECT_NEAR(analysis.loops[0].center_index[0], 9.53, 0.5);
    EXPECT_NEAR(analysis.loops[0].center_index[1], 9.41, 0.5);
  }
}

/// Of M, by the ranks of its boundary matrices, in the whole grid written out.
std::array<std::int64_t, 3> betti_by_ranks(const SmallVolume& volume) {
  std::array<std::uint32_t, 3> dims{};
  for (int a = 0; a < 3; ++a) dims[a] = static_cast<std::uint32_t>(volume.dims[a]);
  const Lattice box = make_lattice({0, 0, 0}, dims);
  const VoxelSides sides = classify(volume.view(), testing::zero_level, Boundary::open);
  return oracle::betti_of_m(
      oracle::build_complex(volume.values, volume.dims, box, testing::walls_of(sides, box)));
}

TEST(OpenBoundary, CountsEqualTheRanksOnThousandsOfVolumes) {
  std::atomic<int> different = 0;
  std::atomic<std::int64_t> loops = 0;
  tbb::parallel_for(std::uint32_t{0}, std::uint32_t{6000}, [&](std::uint32_t i) {
    const SmallVolume volume = noise(i, 6);
    const Betti betti = count_topology(volume.view(), testing::zero_level, open_options()).betti;
    if (std::array{betti.b0, betti.b1, betti.b2} != betti_by_ranks(volume)) ++different;
    loops += betti.b1;
  });
  EXPECT_EQ(different, 0);
  EXPECT_GT(loops, 10'000);
}

TEST(OpenBoundary, EulerCharacteristicAndBordersAddUp) {
  for (std::uint32_t i = 0; i < 300; ++i) {
    const SmallVolume volume = noise(i, 7);
    const Prepared prepared(volume, GeodesicMode::exact, Boundary::open);
    const Surface& surface = prepared.surface;
    const ExplicitComplex slow = oracle::build_complex(
        volume.values, volume.dims, prepared.sides.lattice, testing::walls_of(prepared.sides));
    if (!surface.points.empty()) {
      ASSERT_EQ(surface.euler(), oracle::euler_of_m(slow)) << "volume " << i;
    }
    std::int64_t sum = 0;
    for (const SurfaceComponent& component : surface.components) {
      sum += component.euler;
      ASSERT_EQ(component.euler, 2 - 2 * component.genus - component.borders) << "volume " << i;
      ASSERT_GE(component.genus, 0);
    }
    ASSERT_EQ(sum, surface.euler());
    ASSERT_EQ(num_edges(surface.graph.csr),
              3 * surface.triangles.size() + surface.border_edges.size());
  }
}

/// Both engines against the slow reduction of the two sides in one filtration; what differs.
std::string compare_with_oracle(const SmallVolume& volume, std::atomic<std::size_t>& compared) {
  const Prepared prepared(volume, GeodesicMode::exact, Boundary::open);
  if (prepared.surface.points.empty()) return "";
  const ExplicitComplex slow = oracle::build_complex(
      volume.values, volume.dims, prepared.sides.lattice, testing::walls_of(prepared.sides));
  constexpr std::array both{Side::inside, Side::outside};
  std::vector<SidedPiece> expected = testing::slow_killing_pieces(prepared, slow, both);
  std::vector<SidedPiece> by_pair;
  for (const SurfacePair& pair : testing::pairs_of(prepared, Refinement::both))
    by_pair.push_back({pair.side, pair.piece});
  if (by_pair != expected) return "PAIR's killing pieces differ";
  std::vector<SidedPiece> by_dual;
  for (const Side side : both) {
    const DualPass pass = prepared.pass_on(side);
    if (!labels_are_consistent(prepared.complex(side), pass)) return "the labels are no cocycle";
    for (const KillingPiece& killing : pass.killing) by_dual.push_back({side, killing.piece});
  }
  std::sort(by_dual.begin(), by_dual.end());
  std::sort(expected.begin(), expected.end());
  if (by_dual != expected) return "the dual pass's killing pieces differ";
  if (static_cast<std::int64_t>(expected.size()) != betti_by_ranks(volume)[1])
    return "not every loop of the surface dies";
  compared += expected.size();
  return "";
}

TEST(OpenBoundary, BothEnginesFindTheKillingPiecesOfTheSlowReduction) {
  std::atomic<std::size_t> compared = 0;
  tbb::parallel_for(std::uint32_t{0}, std::uint32_t{1500}, [&](std::uint32_t i) {
    EXPECT_EQ(compare_with_oracle(noise(i, 6), compared), "") << "volume " << i;
  });
  EXPECT_GT(compared, 2'500U);
}

TEST(OpenBoundary, EveryLoopIsProvedByBothEnginesOnThousandsOfVolumes) {
  tbb::parallel_for(std::uint32_t{0}, std::uint32_t{2000}, [&](std::uint32_t i) {
    const SmallVolume volume = noise(i, 9);
    // analyze() throws unless the loops are a basis of H1(M).
    for (const Engine engine : {Engine::dual, Engine::pair}) {
      const Analysis analysis = open_loops(volume, engine);
      EXPECT_EQ(static_cast<std::int64_t>(analysis.loops.size()), analysis.surface.betti1());
    }
  });
}

TEST(OpenBoundary, EveryRefinementGivesABasis) {
  for (const Refinement refinement :
       {Refinement::none, Refinement::first, Refinement::second, Refinement::both})
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
      AnalysisOptions options = open_options(Engine::pair);
      options.pair.refinement = refinement;
      const Analysis analysis =
          analyze(testing::white_noise({8, 8, 8}, seed).view(), testing::zero_level, options);
      EXPECT_EQ(static_cast<std::int64_t>(analysis.loops.size()), analysis.surface.betti1());
    }
}

TEST(OpenBoundary, KillingPiecesAreThoseOfAClosedSurfaceThatNeverMeetsTheBorder) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SmallVolume volume = testing::white_noise({7, 8, 7}, seed);
    for (std::int64_t n = 0; n < 7 * 8 * 7; ++n) {
      const Index3 p{n % 7, n / 7 % 8, n / 56};
      for (int a = 0; a < 3; ++a)
        if (p[a] == 0 || p[a] + 1 == volume.dims[a])
          volume.values[static_cast<std::size_t>(n)] = -1.0;
    }
    const Prepared open(volume, GeodesicMode::exact, Boundary::open);
    const Prepared closed(volume);
    ASSERT_TRUE(open.surface.border_edges.empty());
    EXPECT_EQ(open.surface.betti1(), 2 * closed.surface.genus());
    for (const Side side : {Side::inside, Side::outside})
      EXPECT_EQ(testing::killing_pieces(open.pass_on(side)),
                testing::killing_pieces(closed.pass_on(side)));
  }
}

TEST(OpenBoundary, OfAVolumeAllInsideOrAllOutsideHasNoSurface) {
  for (const double value : {1.0, -1.0}) {
    const SmallVolume volume{std::vector<double>(27, value), {3, 3, 3}};
    const Analysis analysis = open_loops(volume, Engine::dual);
    EXPECT_TRUE(analysis.surface.points.empty());
    EXPECT_TRUE(analysis.loops.empty());
    EXPECT_EQ(analysis.betti.b0, 0);
  }
}

TEST(OpenBoundary, OfOneVoxelAlongAnAxisIsRefused) {
  const SmallVolume volume{std::vector<double>(9, 1.0), {3, 3, 1}};
  EXPECT_THROW(open_loops(volume, Engine::dual), InvalidArgument);
}

}  // namespace
}  // namespace isoloop
