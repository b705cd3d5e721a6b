#include "core/surface/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/oracles/explicit_complex.h"
#include "tests/oracles/refined_field.h"
#include "tests/oracles/slow_reduction.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using testing::SmallVolume;
using testing::zero_level;

struct Cut {
  VoxelSides sides;
  EdgeIndex edges;
  Surface surface;
};

Cut cut_volume(const SmallVolume& volume, const Vec3& spacing = {1, 1, 1}) {
  GridView<double> view = volume.view();
  view.spacing = spacing;
  VoxelSides sides = classify(view, zero_level);
  EdgeIndex edges(sides);
  Surface surface = extract_surface(view, zero_level, sides, edges);
  return {std::move(sides), std::move(edges), std::move(surface)};
}

/// From the middle of a cube of `side` voxels to its voxel number n.
double distance_to_middle(int n, int side) {
  const double middle = 0.5 * (side - 1);
  const std::div_t rows = std::div(n, side);
  const std::div_t layers = std::div(rows.quot, side);
  return std::hypot(rows.rem - middle, layers.rem - middle, layers.quot - middle);
}

/// Whether the triangles round every vertex form one fan that closes.
std::string complaint_about_manifold(const Surface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> across;  // directed edge -> apex
  std::vector<int> triangles_at(surface.points.size());
  for (const auto& t : surface.triangles)
    for (int i = 0; i < 3; ++i) {
      ++triangles_at[t[i]];
      if (!across.try_emplace({t[i], t[(i + 1) % 3]}, t[(i + 2) % 3]).second)
        return "a directed edge occurs twice";
    }
  for (const auto& [edge, apex] : across)
    if (across.count({edge.second, edge.first}) == 0) return "an edge has one triangle only";
  std::vector<bool> seen(surface.points.size());
  for (const auto& [edge, apex] : across) {
    const std::uint32_t hub = edge.first;
    if (seen[hub]) continue;
    seen[hub] = true;
    int turns = 0;
    std::uint32_t rim = edge.second;
    do {
      rim = across.at({hub, rim});
      ++turns;
    } while (rim != edge.second && turns <= triangles_at[hub]);
    if (turns != triangles_at[hub]) return "the triangles at a vertex are no single fan";
  }
  return std::find(seen.begin(), seen.end(), false) == seen.end() ? "" : "a vertex is alone";
}

TEST(Surface, IsAClosedManifoldOnWhiteNoise) {
  for (std::uint32_t seed = 0; seed < 200; ++seed)
    ASSERT_EQ(complaint_about_manifold(cut_volume(testing::white_noise({6, 7, 5}, seed)).surface),
              "")
        << seed;
}

TEST(Surface, EulerCharacteristicIsThatOfTheWrittenOutComplex) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const SmallVolume volume = testing::white_noise({5, 4, 5}, seed);
    const Cut cut = cut_volume(volume);
    const auto slow = oracle::build_complex(volume.values, volume.dims, cut.sides.lattice,
                                            testing::walls_of(cut.sides));
    ASSERT_EQ(cut.surface.euler(), oracle::euler_of_m(slow));
    std::int64_t sum = 0;
    for (const SurfaceComponent& component : cut.surface.components) sum += component.euler;
    ASSERT_EQ(sum, cut.surface.euler());
  }
}

TEST(Surface, SolidsInGaussianFieldsHaveTheRefinedEulerCharacteristic) {
  std::size_t tunnels = 0;
  for (std::uint32_t seed = 0; seed < 3; ++seed) {
    const SmallVolume volume = testing::gaussian_field({20, 20, 20}, 0.5 + 0.25 * seed, seed);
    const Cut cut = cut_volume(volume);
    tunnels += cut.sides.tunnels.size();
    EXPECT_EQ(cut.surface.euler() / 2, testing::refined_euler(volume).euler);
  }
  EXPECT_GT(tunnels, 10U);
}

TEST(Surface, EnclosesThePositiveVolumeOfABall) {
  SmallVolume ball{{}, {21, 21, 21}};
  for (int n = 0; n < 21 * 21 * 21; ++n) ball.values.push_back(8.0 - distance_to_middle(n, 21));
  const Surface surface = cut_volume(ball, {1.0, 0.5, 2.0}).surface;
  double volume = 0.0;
  for (const auto& t : surface.triangles) {
    const Vec3 p = scaled_point(surface, t[0]);
    const Vec3 q = scaled_point(surface, t[1]);
    const Vec3 r = scaled_point(surface, t[2]);
    volume += (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
               p[2] * (q[0] * r[1] - q[1] * r[0])) /
              6;
  }
  EXPECT_NEAR(volume, 4.0 / 3.0 * 3.14159265 * 512, 0.02 * 2144);
  ASSERT_EQ(surface.components.size(), 1U);
  EXPECT_EQ(surface.components[0].genus, 0);
  EXPECT_FALSE(surface.components[0].bounds_cavity);
}

TEST(Surface, VerticesLieStrictlyWithinTheirGridEdges) {
  SmallVolume volume = testing::white_noise({6, 6, 6}, 3);
  for (std::size_t n = 0; n < volume.values.size(); n += 3) volume.values[n] = 0.0;  // f = iso
  const Cut cut = cut_volume(volume);
  for (std::size_t v = 0; v < cut.surface.grid_edges.size(); ++v) {
    const std::uint32_t edge = cut.surface.grid_edges[v];
    const auto lower = cut.sides.lattice.position(edge / 3);
    for (std::uint32_t a = 0; a < 3; ++a) {
      const double along =
          cut.surface.points[v][a] - static_cast<double>(cut.sides.lattice.first[a]) - lower[a];
      if (a == edge % 3) {
        EXPECT_GE(along, 0.0009);
        EXPECT_LE(along, 0.9991);
      } else {
        EXPECT_EQ(along, 0.0);
      }
    }
  }
  for (const float length : cut.surface.graph.lengths) EXPECT_GT(length, 0.0F);
}

TEST(Surface, VerticesFarOutKeepOffTheVoxelsInSinglePrecision) {
  // A long bar, tied with the iso value at every other voxel, that reaches to where a thousandth
  // of a voxel rounds to none.
  constexpr std::int64_t far_out = 1'000'000;
  for (const std::int64_t start : {std::int64_t{16'000}, std::int64_t{500'000}, far_out}) {
    const Index3 dims{start + 12, 3, 3};
    std::vector<float> values(static_cast<std::size_t>(dims[0]) * 9, -1.0F);
    for (std::int64_t n = 0; n < 9; ++n)
      for (std::int64_t x = start; x < start + 8; ++x)
        values[static_cast<std::size_t>(x + dims[0] * n)] = (x + n) % 3 == 0   ? 0.0F
                                                            : (x + n) % 3 == 1 ? 1e9F
                                                                               : -1e-9F;
    const GridView<float> grid{values, dims};
    const VoxelSides sides = classify(grid, IsoLevel{0.0, InsideRule::above});
    const EdgeIndex edges(sides);
    const Surface surface = extract_surface(grid, IsoLevel{0.0, InsideRule::above}, sides, edges);
    ASSERT_FALSE(surface.points.empty());
    for (std::size_t v = 0; v < surface.grid_edges.size(); ++v) {
      const auto axis = surface.grid_edges[v] % 3;
      const double along = surface.points[v][axis];
      EXPECT_NE(along, std::floor(along));
    }
    for (const float length : surface.graph.lengths) EXPECT_GT(length, 0.0F);
  }
}

TEST(Surface, InfiniteVoxelsGiveFinitePoints) {
  SmallVolume volume = testing::white_noise({5, 5, 5}, 1);
  for (std::size_t n = 0; n < volume.values.size(); n += 4)
    volume.values[n] = std::copysign(std::numeric_limits<double>::infinity(), volume.values[n]);
  for (const auto& point : cut_volume(volume).surface.points)
    for (const float x : point) EXPECT_TRUE(std::isfinite(x));
}

TEST(Surface, MarksTheWallOfACavity) {
  SmallVolume shell{{}, {15, 15, 15}};
  for (int n = 0; n < 15 * 15 * 15; ++n) {
    const double r = distance_to_middle(n, 15);
    shell.values.push_back(std::min(6.2 - r, r - 2.9));
  }
  const Surface surface = cut_volume(shell).surface;
  ASSERT_EQ(surface.components.size(), 2U);
  EXPECT_NE(surface.components[0].bounds_cavity, surface.components[1].bounds_cavity);
  EXPECT_FALSE(surface.components[0].bounds_cavity) << "the outer wall comes first in scan order";
}

TEST(Surface, EdgeGraphHoldsEachEdgeInBothDirections) {
  const Surface surface = cut_volume(testing::smooth_noise({9, 9, 9}, 5, 1)).surface;
  std::map<std::pair<std::uint32_t, std::uint32_t>, float> lengths;
  for (std::uint32_t u = 0; u < surface.graph.vertex_count(); ++u)
    surface.graph.for_each_out_edge(u, [&](std::uint32_t v, std::uint32_t edge) {
      lengths[{u, v}] = surface.graph.lengths[edge];
    });
  EXPECT_EQ(lengths.size(), 3 * surface.triangles.size());
  for (const auto& [edge, length] : lengths)
    EXPECT_EQ(lengths.at({edge.second, edge.first}), length);
}

TEST(Surface, IsEmptyWhereNothingIsInside) {
  const Surface surface = cut_volume({std::vector<double>(27, -1.0), {3, 3, 3}}).surface;
  EXPECT_TRUE(surface.points.empty());
  EXPECT_EQ(surface.genus(), 0);
}

}  // namespace
}  // namespace isoloop
