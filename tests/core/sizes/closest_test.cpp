#include "core/sizes/closest.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "core/octree/leaves.h"
#include "core/octree/octree.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

/// Largest excess of the distances found over the least ones, over all vertices of the grid and of
/// an octree.
double worst_excess(const testing::SmallVolume& volume, const Vec3& spacing) {
  GridView<double> view = volume.view();
  view.spacing = spacing;
  const VoxelSides sides = classify(view, testing::zero_level);
  const EdgeIndex edges(sides);
  const Surface surface = extract_surface(view, testing::zero_level, sides, edges);
  const auto closest = closest_surface_vertices(sides, edges, surface);
  const Octree octree(sides, graded_leaves(sides, spacing, 1));
  const auto in_octree = closest_surface_vertices(octree, surface);
  double worst = 0.0;
  const auto compare = [&](std::uint32_t v, std::uint32_t found) {
    const auto at = sides.lattice.position(v);
    Vec3 p{};
    for (int a = 0; a < 3; ++a)
      p[a] = (static_cast<double>(sides.lattice.first[a]) + at[a]) * spacing[a];
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t u = 0; u < surface.grid_edges.size(); ++u)
      least = std::min(least, distance(p, scaled_point(surface, u)));
    worst = std::max(worst, distance(p, scaled_point(surface, found)) - least);
  };
  for (std::uint32_t v = 0; v < sides.lattice.vertex_count(); ++v) compare(v, closest[v]);
  for (std::uint32_t v = 0; v < octree.vertex_count(); ++v)
    compare(octree.lattice_vertex(v), in_octree[v]);
  return worst;
}

TEST(Closest, IsTheClosestOfAllVerticesOfM) {
  for (std::uint32_t seed = 0; seed < 20; ++seed)
    EXPECT_LT(worst_excess(testing::smooth_noise({13, 19, 11}, seed, 2), {1, 1, 1}), 1e-5) << seed;
  EXPECT_LT(worst_excess(testing::torus({40, 40, 24}), {1, 1, 1}), 1e-5);
}

TEST(Closest, MeasuresInUnitsOfTheSpacing) {
  for (std::uint32_t seed = 0; seed < 20; ++seed)
    EXPECT_LT(worst_excess(testing::smooth_noise({11, 9, 18}, seed, 2), {0.5, 2.0, 3.5}), 1e-5);
}

TEST(Closest, TakesLinesLongerThanABatch) {
  EXPECT_LT(worst_excess(testing::white_noise({37, 3, 2}, 1), {1, 1, 1}), 1e-5);
  EXPECT_LT(worst_excess(testing::white_noise({2, 35, 3}, 2), {1, 1, 1}), 1e-5);
}

}  // namespace
}  // namespace isoloop
