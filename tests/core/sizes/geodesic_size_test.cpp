#include "core/sizes/geodesic_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/oracles/shortest_paths.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using testing::Prepared;
using testing::SmallVolume;

/// Sizes of all edges off M on one side, in no particular order.
std::vector<float> edge_sizes(const Prepared& p, Side side) {
  std::vector<float> sizes;
  for (const std::uint32_t edge : all_edges(p.complex(side)))
    sizes.push_back(side == Side::outside && p.edges.is_cut(edge)
                        ? p.sizes.of_outside_half[p.edges.vertex_on(edge)]
                        : p.sizes.by_edge[edge]);
  return sizes;
}

/// The sizes of all grid edges at every `every`-th vertex, and of the halves of cut ones.
void expect_exact_sizes(const Prepared& p, std::uint32_t every) {
  const Lattice& lattice = p.sides.lattice;
  for (std::uint32_t v = 0; v < lattice.vertex_count(); v += every) {
    const auto from = testing::boost_distances(p.surface.graph, p.closest[v]);
    const auto expect_size = [&](float size, std::uint32_t end) {
      if (std::isinf(from[end]))
        ASSERT_TRUE(std::isinf(size)) << v;
      else
        ASSERT_NEAR(size, from[end], 1e-3) << v;
    };
    const auto position = lattice.position(v);
    for (std::uint32_t a = 0; a < 3; ++a) {
      if (position[a] + 1 == lattice.dims[a]) continue;
      const std::uint32_t edge = 3 * v + a;
      if (!p.edges.is_cut(edge)) {
        expect_size(p.sizes.by_edge[edge], p.closest[v + lattice.stride[a]]);
      } else {
        const std::uint32_t crossing = p.edges.vertex_on(edge);
        expect_size(p.sides.is_on(Side::inside, v) ? p.sizes.by_edge[edge]
                                                   : p.sizes.of_outside_half[crossing],
                    crossing);
      }
    }
  }
}

TEST(GeodesicSize, ExactSizesAreThoseOfBoostsDijkstra) {
  for (const SmallVolume& volume :
       {testing::smooth_noise({10, 9, 11}, 4, 2), testing::linked_tori({20, 20, 20})})
    expect_exact_sizes(Prepared(volume), 17);
}

// Rows and layers of two vertices, and few of M: what lies beside an edge by its number may be no
// edge of the box there, and yet have the same ends.
TEST(GeodesicSize, ExactSizesAreThoseOfBoostsDijkstraInThinOpenBoxes) {
  for (const Index3& dims : {Index3{2, 6, 6}, Index3{6, 2, 6}, Index3{6, 6, 2}, Index3{2, 2, 6}})
    for (std::uint32_t seed = 0; seed < 4000; ++seed) {
      SmallVolume volume = testing::white_noise(dims, seed);
      for (double& value : volume.values) value += seed % 2 == 0 ? 0.8 : -0.8;
      const Prepared p(volume, GeodesicMode::exact, Boundary::open);
      if (!p.surface.points.empty()) expect_exact_sizes(p, 1);
    }
}

TEST(GeodesicSize, HalvesOfACutEdgeLeadToItsVertexOnM) {
  const Prepared p(testing::torus({18, 18, 12}));
  for (std::uint32_t m = 0; m < p.surface.grid_edges.size(); ++m) {
    const std::uint32_t edge = p.surface.grid_edges[m];
    const std::uint32_t lower = edge / 3;
    const std::uint32_t upper = lower + p.sides.lattice.stride[edge % 3];
    const std::uint32_t inner = p.sides.is_on(Side::inside, lower) ? lower : upper;
    EXPECT_EQ(p.sizes.by_edge[edge] == 0.0F, p.closest[inner] == m);
    EXPECT_EQ(p.sizes.of_outside_half[m] == 0.0F, p.closest[lower + upper - inner] == m);
  }
}

TEST(GeodesicSize, EdgesFarFromASmallSurfaceTakeLittleMemory) {
  SmallVolume volume = testing::torus({48, 48, 24});
  const Prepared near(volume);
  volume.values.front() = volume.values.back() = 1.0;  // a box beyond the torus
  const Prepared far(volume);
  const double more = far.sides.lattice.vertex_count() - near.sides.lattice.vertex_count();
  EXPECT_GT(more, 10'000);
  const auto bytes = static_cast<double>(far.sizes.by_edge.bytes() - near.sizes.by_edge.bytes());
  EXPECT_LT(bytes, 7 * more);
}

/// Sizes by the hierarchy over exact ones, of the edges beyond the exact radius.
std::vector<double> ratios_beyond_the_exact_radius(const SmallVolume& volume) {
  const Prepared exact(volume);
  const Prepared fast(volume, GeodesicMode::hierarchy);
  std::vector<double> ratios;
  for (const Side side : {Side::inside, Side::outside}) {
    const std::vector<float> slow_sizes = edge_sizes(exact, side);
    const std::vector<float> fast_sizes = edge_sizes(fast, side);
    for (std::size_t i = 0; i < slow_sizes.size(); ++i) {
      if (slow_sizes[i] <= 5.0F || std::isinf(slow_sizes[i])) {
        EXPECT_EQ(fast_sizes[i], slow_sizes[i]);
        continue;
      }
      EXPECT_GE(fast_sizes[i], 5.0F);
      ratios.push_back(fast_sizes[i] / slow_sizes[i]);
    }
  }
  return ratios;
}

void expect_mean_and_deviation(const std::vector<double>& ratios, double mean, double deviation) {
  const auto count = static_cast<double>(ratios.size());
  ASSERT_GT(count, 500);
  double sum = 0.0;
  double squares = 0.0;
  for (const double r : ratios) sum += r;
  for (const double r : ratios) squares += (r - sum / count) * (r - sum / count);
  EXPECT_NEAR(sum / count, mean, 0.04);
  EXPECT_NEAR(std::sqrt(squares / count), deviation, 0.04);
}

TEST(GeodesicSize, HierarchyStaysAsCloseToTheExactSizesAsItsHeaderSays) {
  expect_mean_and_deviation(ratios_beyond_the_exact_radius(testing::torus({64, 64, 64})), 1.03,
                            0.12);
  for (std::uint32_t seed = 0; seed < 2; ++seed)
    expect_mean_and_deviation(
        ratios_beyond_the_exact_radius(testing::smooth_noise({36, 36, 36}, seed, 4)), 1.00, 0.12);
}

TEST(GeodesicSize, SurvivesTheFortyEightSymmetries) {
  // An odd number of voxels: diagonals follow the parity of the grid lines, which flips then keep.
  const SmallVolume volume = testing::smooth_noise({11, 9, 13}, 2, 2);
  const auto sorted_sizes = [](const SmallVolume& v, Side side) {
    std::vector<float> sizes = edge_sizes(Prepared(v), side);
    std::sort(sizes.begin(), sizes.end());
    return sizes;
  };
  for (const Side side : {Side::inside, Side::outside}) {
    const std::vector<float> expected = sorted_sizes(volume, side);
    std::array<int, 3> permutation{0, 1, 2};
    do {
      for (int flips = 0; flips < 8; ++flips) {
        const std::vector<float> sizes = sorted_sizes(
            testing::transformed(volume, permutation,
                                 {(flips & 1) != 0, (flips & 2) != 0, (flips & 4) != 0}),
            side);
        ASSERT_EQ(sizes.size(), expected.size());
        for (std::size_t i = 0; i < sizes.size(); ++i) {
          if (std::isinf(expected[i]))
            ASSERT_TRUE(std::isinf(sizes[i]));
          else
            ASSERT_NEAR(sizes[i], expected[i], 0.11 * expected[i] + 0.5);
        }
      }
    } while (std::next_permutation(permutation.begin(), permutation.end()));
  }
}

TEST(GeodesicSize, IsInfiniteBetweenComponents) {
  const Prepared p(testing::torus_shell({24, 24, 24}));
  const std::vector<float> sizes = edge_sizes(p, Side::inside);
  EXPECT_TRUE(std::any_of(sizes.begin(), sizes.end(), [](float s) { return std::isinf(s); }));
  EXPECT_TRUE(std::all_of(sizes.begin(), sizes.end(), [](float s) { return s >= 0.0F; }));
}

}  // namespace
}  // namespace isoloop
