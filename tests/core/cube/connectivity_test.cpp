// Masks beside counts of their digital topology that know nothing of surfaces.
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "tests/oracles/voxel_oracle.h"

namespace isoloop {
namespace {

const std::map<int, Topology> topologies{
    {6, Topology::connected_6}, {18, Topology::connected_18}, {26, Topology::connected_26}};

// `density`: the chance of a voxel to be inside. One layer of outside all round.
oracle::Mask random_mask(const Index3& dims, double density, std::uint32_t seed) {
  std::mt19937 random(seed);
  oracle::Mask mask{.voxels = {}, .dims = {dims[0] + 2, dims[1] + 2, dims[2] + 2}};
  mask.voxels.resize(static_cast<std::size_t>(mask.dims[0] * mask.dims[1] * mask.dims[2]));
  for (std::int64_t k = 1; k <= dims[2]; ++k) {
    for (std::int64_t j = 1; j <= dims[1]; ++j) {
      for (std::int64_t i = 1; i <= dims[0]; ++i) {
        const auto at = static_cast<std::size_t>(i + mask.dims[0] * (j + mask.dims[1] * k));
        mask.voxels[at] = random() < density * 4294967296.0 ? 1 : 0;
      }
    }
  }
  return mask;
}

GridView<std::uint8_t> view_of(const oracle::Mask& mask) {
  return {mask.voxels, mask.dims, {1, 1, 1}};
}

void expect_counts(const oracle::Mask& mask, int adjacency) {
  const oracle::Betti expected = oracle::count_betti(mask, adjacency);
  const IsoLevel level{0.5, InsideRule::above, topologies.at(adjacency)};
  const Analysis analysis = count_topology(view_of(mask), level);
  EXPECT_EQ(analysis.betti.b0, expected.b0) << adjacency;
  EXPECT_EQ(analysis.betti.b1, expected.b1) << adjacency;
  EXPECT_EQ(analysis.betti.b2, expected.b2) << adjacency;
}

TEST(Connectivity, EveryCubeHasTheDigitalTopologyOfItsCorners) {
  for (unsigned corners = 0; corners < 256; ++corners) {
    oracle::Mask mask{.voxels = std::vector<std::uint8_t>(64), .dims = {4, 4, 4}};
    for (unsigned c = 0; c < 8; ++c) {
      mask.voxels[1 + (c & 1) + 4 * (1 + (c >> 1 & 1)) + 16 * (1 + (c >> 2))] = corners >> c & 1;
    }
    for (const int adjacency : {6, 18, 26}) expect_counts(mask, adjacency);
  }
}

TEST(Connectivity, RandomMasksHaveTheirDigitalTopology) {
  std::uint32_t seed = 1;
  for (const double density : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    for (int round = 0; round < 300; ++round) {
      const oracle::Mask mask = random_mask({5, 6, 4}, density, seed++);
      for (const int adjacency : {6, 18, 26}) expect_counts(mask, adjacency);
    }
  }
}

TEST(Connectivity, LargeMasksHaveTheirDigitalTopology) {
  for (const double density : {0.2, 0.5, 0.8}) {
    const oracle::Mask mask = random_mask({40, 40, 40}, density, 7);
    for (const int adjacency : {6, 18, 26}) expect_counts(mask, adjacency);
  }
}

// Inside by 26 and outside by 6, or the other way round: the same surface, its sides exchanged.
TEST(Connectivity, TheComplementHasTheDualTopology) {
  for (std::uint32_t seed = 1; seed <= 100; ++seed) {
    const oracle::Mask mask = random_mask({5, 5, 5}, 0.5, seed);
    oracle::Mask complement = mask;
    for (std::uint8_t& voxel : complement.voxels) voxel = voxel == 0 ? 1 : 0;
    const auto genus = [](const oracle::Mask& of, InsideRule rule, Topology topology) {
      return count_topology(view_of(of), {0.5, rule, topology}).surface.genus();
    };
    EXPECT_EQ(genus(mask, InsideRule::above, Topology::connected_26),
              genus(complement, InsideRule::below, Topology::connected_26));
  }
}

TEST(Connectivity, LoopsAreFoundAndProvedUnderEach) {
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    const oracle::Mask mask = random_mask({7, 7, 7}, 0.45, seed);
    for (const auto& [adjacency, topology] : topologies) {
      for (const Engine engine : {Engine::dual, Engine::pair}) {
        AnalysisOptions options;
        options.engine = engine;
        options.tighten = engine == Engine::dual ? Tighten::basis : Tighten::none;
        const IsoLevel level{0.5, InsideRule::above, topology};
        const Analysis analysis = analyze(view_of(mask), level, options);
        EXPECT_EQ(static_cast<std::int64_t>(analysis.loops.size()),
                  2 * oracle::count_betti(mask, adjacency).b1);
      }
    }
  }
}

TEST(Connectivity, ValuesDoNotMatterOnlySignsDo) {
  std::mt19937 random(3);
  const oracle::Mask mask = random_mask({6, 6, 6}, 0.5, 11);
  std::vector<float> values;
  for (const std::uint8_t voxel : mask.voxels) {
    const auto size = static_cast<float>(random() % 1000 + 1);
    values.push_back(voxel == 1 ? size : -size);
  }
  const GridView<float> view{values, mask.dims, {1, 1, 1}};
  for (const auto& [adjacency, topology] : topologies) {
    const Analysis analysis = count_topology(view, {0.0, InsideRule::above, topology});
    EXPECT_EQ(analysis.betti.b1, oracle::count_betti(mask, adjacency).b1) << adjacency;
  }
}

}  // namespace
}  // namespace isoloop
