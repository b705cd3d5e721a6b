#include "volume/mesh/mesh_weld.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/samples/mesh_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/mesh/mesh_closure.h"

namespace isoloop {
namespace {

using test::box_mesh;
using test::contains;
using test::torus_mesh;

/// Each triangle with corners of its own, each moved by up to `most` along each axis.
Mesh shaken_soup(const Mesh& mesh, double most) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> move(-most, most);
  Mesh soup;
  for (const auto& triangle : mesh.triangles) {
    const auto next = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t corner : triangle) {
      Vec3 point = mesh.points[corner];
      for (double& c : point) c += move(random);
      soup.points.push_back(point);
    }
    soup.triangles.push_back({next, next + 1, next + 2});
  }
  return soup;
}

std::size_t points_in_triangles(const Mesh& mesh) {
  std::vector<bool> used(mesh.points.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) used[corner] = true;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

TEST(MeshWeld, CornersThatDifferInTheirLastBitsAreOne) {
  const Mesh torus = torus_mesh({40, -20, 7}, 3, 1, 40, 20);  // diagonal 11.5
  const Mesh soup = weld_equal_points(shaken_soup(torus, 1e-6));
  EXPECT_EQ(closure_of(soup).open_edges, 3 * torus.triangles.size());
  const Mesh mesh = weld_borders(soup, "a.stl");
  EXPECT_EQ(closure_of(mesh).open_edges, 0U);
  EXPECT_EQ(closure_of(mesh).one_way_edges, 0U);
  EXPECT_EQ(mesh.triangles.size(), torus.triangles.size());
  EXPECT_EQ(points_in_triangles(mesh), torus.points.size());
  ASSERT_EQ(mesh.warnings.size(), 1U);
  EXPECT_TRUE(contains(mesh.warnings[0].text, "4000 corners at open edges lie within 1.1"))
      << mesh.warnings[0].text;
  EXPECT_TRUE(contains(mesh.warnings[0].text, "closes 4800 of 4800 open edges"))
      << mesh.warnings[0].text;
}

TEST(MeshWeld, CornersThatAreFartherApartStayTwo) {
  const Mesh torus = torus_mesh({0, 0, 0}, 3, 1, 40, 20);
  const Mesh soup = shaken_soup(torus, 1e-3);
  const Mesh mesh = weld_borders(soup, "a.stl");
  EXPECT_EQ(mesh.triangles, soup.triangles);
  EXPECT_TRUE(mesh.warnings.empty());
}

TEST(MeshWeld, AClosedMeshStaysAsItIs) {
  Mesh mesh = torus_mesh({0, 0, 0}, 3, 1, 12, 8);
  mesh = test::joined(mesh, box_mesh({9, 9, 9}, {9.000001, 9.000001, 9.000001}));
  const Mesh welded = weld_borders(mesh, "a.stl");
  EXPECT_EQ(welded.triangles, mesh.triangles);
  EXPECT_TRUE(welded.warnings.empty());
}

TEST(MeshWeld, NoTriangleIsLost) {
  // A soup of a torus, and beside it one of a box that is smaller than the tolerance.
  const Mesh torus = shaken_soup(torus_mesh({0, 0, 0}, 3, 1, 40, 20), 1e-7);
  const Mesh tiny = shaken_soup(box_mesh({9, 9, 9}, {9 + 1e-6, 9 + 1e-6, 9 + 1e-6}), 0.0);
  const Mesh both = weld_equal_points(test::joined(torus, tiny));
  const Mesh mesh = weld_borders(both, "a.stl");
  EXPECT_EQ(mesh.triangles.size(), both.triangles.size());
  EXPECT_EQ(closure_of(mesh).open_edges, 0U);
  for (const auto& t : mesh.triangles) {
    EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
  }
}

TEST(MeshWeld, TrianglesOfAnOpenMeshThatAreSmallerThanTheToleranceStay) {
  Mesh mesh = torus_mesh({0, 0, 0}, 3, 1, 12, 8);
  Mesh tiny = box_mesh({9, 9, 9}, {9 + 1e-6, 9 + 1e-6, 9 + 1e-6});
  tiny.triangles.pop_back();
  mesh = test::joined(mesh, tiny);
  const Mesh welded = weld_borders(mesh, "a.stl");
  EXPECT_EQ(welded.triangles, mesh.triangles);
}

TEST(MeshWeld, ACrackIsClosedWhereItIsOne) {
  Mesh cracked = box_mesh({0, 0, 0}, {4, 4, 4});
  cracked.points.insert(cracked.points.end(), {{0, 0, 1e-6}, {4, 4, 5}, {4, 5, 5}});
  cracked.triangles[0][0] = 8;
  cracked.triangles.push_back({7, 9, 10});  // a fin, which stays open
  EXPECT_EQ(closure_of(cracked).open_edges, 7U);
  const Mesh mesh = weld_borders(cracked, "a.stl");
  EXPECT_EQ(closure_of(mesh).open_edges, 3U);
  EXPECT_EQ(mesh.triangles.size(), cracked.triangles.size());
}

TEST(MeshWeldData, HollowTorusIsClosed) {
  ISOLOOP_NEEDS("odd/hollow_torus_last_bits.stl");
  const Mesh mesh = read_mesh(test::data("odd/hollow_torus_last_bits.stl"));
  EXPECT_EQ(closure_of(mesh).open_edges, 0U);
  EXPECT_EQ(mesh.triangles.size(), 18432U);
  EXPECT_EQ(points_in_triangles(mesh), 9216U);
  EXPECT_EQ(mesh.warnings.size(), 1U);
}

}  // namespace
}  // namespace isoloop
