#include "tools/drawings/simplified_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "core/base/disjoint_sets.h"
#include "tests/oracles/random_volumes.h"

namespace isoloop {
namespace {

using testing::SmallVolume;

TriangleMesh mesh_of(const Surface& surface) {
  TriangleMesh mesh;
  for (const auto& p : surface.points) mesh.points.push_back({p[0], p[1], p[2]});
  mesh.triangles = surface.triangles;
  return mesh;
}

/// Euler characteristic of each component, sorted; empty unless every edge has two triangles, which
/// run along it in opposite directions, and every vertex has one fan.
std::vector<std::int64_t> euler_of_components(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> apex;  // by directed edge
  DisjointSets sets(static_cast<std::uint32_t>(mesh.points.size()));
  std::vector<std::size_t> degree(mesh.points.size());
  for (const auto& corners : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = corners[i];
      const std::uint32_t to = corners[(i + 1) % 3];
      if (from == to || !apex.emplace(std::pair{from, to}, corners[(i + 2) % 3]).second) return {};
      sets.unite(from, to);
      ++degree[from];
    }
  for (const auto& [edge, third] : apex)
    if (apex.count({edge.second, edge.first}) == 0) return {};
  for (const auto& corners : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {  // once round the vertex meets all its triangles
      const std::uint32_t v = corners[i];
      std::uint32_t next = corners[(i + 1) % 3];
      std::size_t met = 0;
      do {
        next = apex.at({v, next});
        ++met;
      } while (next != corners[(i + 1) % 3] && met <= degree[v]);
      if (met != degree[v]) return {};
    }
  std::map<std::uint32_t, std::int64_t> euler;  // edges count a half from either side
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) euler[sets.find(v)] += 2;
  for (const auto& corners : mesh.triangles) euler[sets.find(corners[0])] += 2 - 3;
  std::vector<std::int64_t> sorted;
  sorted.reserve(euler.size());
  for (const auto& [root, twice] : euler) sorted.push_back(twice / 2);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

Surface surface_of(const SmallVolume& volume) {
  return count_topology(volume.view(), {0.0, InsideRule::above}).surface;
}

TEST(SimplifiedMesh, GoesFartherWhereSmallHandlesMayGo) {
  const TriangleMesh mesh = mesh_of(surface_of(testing::white_noise({12, 12, 12}, 3)));
  const std::size_t most = simplified(mesh, 0).triangles.size() / 3;
  ASSERT_GT(most, 100U);
  const TriangleMesh simple = simplified(mesh, most, HandleRule::drop_small);
  EXPECT_LE(simple.triangles.size(), most);
  const auto components = [](const TriangleMesh& of) {
    DisjointSets sets(static_cast<std::uint32_t>(of.points.size()));
    std::size_t count = of.points.size();
    for (const auto& [a, b, c] : of.triangles) {
      if (sets.unite(a, b)) --count;
      if (sets.unite(b, c)) --count;
    }
    return count;
  };
  EXPECT_EQ(components(simple), components(mesh)) << "each keeps some triangles";
  for (const auto& [a, b, c] : simple.triangles) {
    EXPECT_TRUE(a != b && b != c && c != a);
    EXPECT_LT(std::max({a, b, c}), simple.points.size());
  }
}

TEST(SimplifiedMesh, KeepsTheTopologyOfEveryComponent) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const SmallVolume volume = seed % 2 == 0 ? testing::smooth_noise({14, 13, 12}, seed, 1)
                                             : testing::white_noise({7, 7, 7}, seed);
    const TriangleMesh mesh = mesh_of(surface_of(volume));
    const auto before = euler_of_components(mesh);
    ASSERT_FALSE(before.empty());
    for (const std::size_t most : {mesh.triangles.size() / 3, std::size_t{0}}) {
      const TriangleMesh simple = simplified(mesh, most);
      EXPECT_EQ(euler_of_components(simple), before) << seed;
      EXPECT_LT(simple.triangles.size(), mesh.triangles.size());
    }
  }
}

TEST(SimplifiedMesh, MeetsItsBudgetAndStaysClose) {
  const Surface surface = surface_of(testing::torus({40, 40, 40}));
  const TriangleMesh simple = simplified(mesh_of(surface), 1000);
  EXPECT_LE(simple.triangles.size(), 1000U);
  EXPECT_GT(simple.triangles.size(), 990U);
  EXPECT_EQ(euler_of_components(simple), std::vector<std::int64_t>{0});
  for (const Vec3& p : simple.points) {
    const double radial = std::hypot(p[0] - 19.53, p[1] - 19.46) - 0.28 * 40;
    EXPECT_NEAR(std::hypot(radial, p[2] - 19.55), 0.12 * 40, 0.25);
  }
}

TEST(SimplifiedMesh, TellsWhichPointsAreLeft) {
  const TriangleMesh mesh = mesh_of(surface_of(testing::torus({40, 40, 40})));
  const TriangleMesh simple = simplified(mesh, 2000);
  ASSERT_EQ(simple.sources.size(), simple.points.size());
  EXPECT_TRUE(std::is_sorted(simple.sources.begin(), simple.sources.end()));
  for (std::size_t i = 0; i < simple.points.size(); ++i)
    EXPECT_LT(distance(simple.points[i], mesh.points[simple.sources[i]]), 4.0);
  EXPECT_EQ(simplified(mesh, mesh.triangles.size()).sources.size(), mesh.points.size());
}

TEST(SimplifiedMesh, LeavesASmallMeshAsItIs) {
  const TriangleMesh mesh = mesh_of(surface_of(testing::torus({16, 16, 16})));
  EXPECT_EQ(simplified(mesh, mesh.triangles.size()).triangles, mesh.triangles);
  EXPECT_TRUE(simplified({}, 0).triangles.empty());
}

TEST(SimplifiedMesh, KeepsABorderWhereItIs) {
  const SmallVolume volume = testing::torus({30, 30, 30}, 0.45, 0.1);  // leaves the box
  AnalysisOptions options;
  options.boundary = Boundary::open;
  const Surface surface = count_topology(volume.view(), {0.0, InsideRule::above}, options).surface;
  ASSERT_FALSE(surface.border_edges.empty());
  const TriangleMesh simple = simplified(mesh_of(surface), surface.triangles.size() / 4);
  EXPECT_LT(simple.triangles.size(), surface.triangles.size() / 2);
  for (const auto& edge : surface.border_edges)
    for (const std::uint32_t v : edge) {
      const auto& p = surface.points[v];
      EXPECT_NE(std::find(simple.points.begin(), simple.points.end(), Vec3{p[0], p[1], p[2]}),
                simple.points.end());
    }
}

}  // namespace
}  // namespace isoloop
