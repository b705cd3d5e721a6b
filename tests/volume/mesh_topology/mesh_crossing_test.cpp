#include "volume/mesh_topology/mesh_crossing.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

#include "tests/samples/mesh_samples.h"

namespace isoloop {
namespace {

bool meet_in(const std::vector<Vec3>& points, const std::array<std::uint32_t, 3>& one,
             const std::array<std::uint32_t, 3>& other) {
  const Mesh mesh{points, {one, other}};
  const bool found = triangles_meet(mesh, 0, 1);
  EXPECT_EQ(triangles_meet(mesh, 1, 0), found);
  return found;
}

TEST(MeshCrossing, SidesAndTurnsHaveTheSignsOfTheirNames) {
  const Vec3 a{0, 0, 0};
  const Vec3 b{1, 0, 0};
  const Vec3 c{0, 1, 0};
  EXPECT_EQ(side_of_plane(a, b, c, {0.3, 0.3, 1}), 1);
  EXPECT_EQ(side_of_plane(a, b, c, {0.3, 0.3, -1}), -1);
  EXPECT_EQ(side_of_plane(a, b, c, {7, -3, 0}), 0);
  EXPECT_EQ(turn(a, b, c, 2), 1);
  EXPECT_EQ(turn(a, c, b, 2), -1);
  EXPECT_EQ(turn(a, b, {2, 0, 0}, 2), 0);
}

TEST(MeshCrossing, TrianglesApart) {
  const std::vector<Vec3> points{{0, 0, 0},  {4, 0, 0}, {0, 4, 0},  // flat
                                 {1, 1, 0},  {1, 1, 3}, {5, 5, 3},  // touches it with a corner
                                 {1, 1, -1}, {3, 3, 0}, {4, 4, 0},  // 3, 4: beside it, in its plane
                                 {9, 0, 0}};
  EXPECT_TRUE(meet_in(points, {0, 1, 2}, {3, 4, 5}));
  EXPECT_TRUE(meet_in(points, {0, 1, 2}, {6, 4, 5}));   // through it
  EXPECT_FALSE(meet_in(points, {0, 1, 2}, {7, 4, 5}));  // a corner in its plane, outside
  EXPECT_FALSE(meet_in(points, {0, 1, 2}, {7, 8, 5}));  // a side in its plane, outside
  EXPECT_FALSE(meet_in(points, {0, 1, 2}, {7, 8, 9}));  // all in its plane, outside
  EXPECT_TRUE(meet_in(points, {0, 1, 2}, {3, 8, 9}));   // all in its plane, and within
}

TEST(MeshCrossing, NeighboursMeetWhereTheyShareMoreThanTheirCorners) {
  const std::vector<Vec3> points{{0, 0, 0},  {4, 0, 0},  {0, 4, 0}, {4, 4, 0},  {1, 1, 0},
                                 {-4, 0, 0}, {0, -4, 0}, {2, 2, 1}, {2, 2, -1}, {1, 1, 1}};
  EXPECT_FALSE(meet_in(points, {0, 1, 2}, {1, 3, 2}));  // one flat square
  EXPECT_TRUE(meet_in(points, {0, 1, 2}, {1, 4, 2}));   // folded back flat
  EXPECT_FALSE(meet_in(points, {0, 1, 2}, {1, 9, 2}));  // folded, not flat
  EXPECT_FALSE(meet_in(points, {0, 1, 2}, {0, 5, 6}));  // a flat fan about a corner
  EXPECT_TRUE(meet_in(points, {0, 1, 2}, {0, 4, 5}));   // overlapping in it
  EXPECT_TRUE(meet_in(points, {0, 1, 2}, {0, 7, 8}));   // through it, from the corner on
  EXPECT_FALSE(meet_in(points, {0, 1, 2}, {0, 7, 9}));
  EXPECT_TRUE(meet_in(points, {0, 1, 2}, {0, 2, 1}));  // the same, turned over
}

/// Whether a segment meets a triangle, by where it meets its plane.
bool pierces(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& t) {
  const auto minus = [](const Vec3& a, const Vec3& b) {
    return Vec3{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto cross = [](const Vec3& a, const Vec3& b) {
    return Vec3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto dot = [](const Vec3& a, const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const Vec3 normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  const double share = dot(normal, minus(t[0], p)) / dot(normal, minus(q, p));
  if (share < 0.0 || share > 1.0) return false;
  Vec3 at{};
  for (std::size_t a = 0; a < 3; ++a) at[a] = p[a] + share * (q[a] - p[a]);
  for (std::size_t c = 0; c < 3; ++c) {
    if (dot(normal, cross(minus(t[(c + 1) % 3], t[c]), minus(at, t[c]))) < 0.0) return false;
  }
  return true;
}

TEST(MeshCrossing, RandomTrianglesMeetWhereASideOfOnePiercesTheOther) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  int meeting = 0;
  for (int round = 0; round < 20000; ++round) {
    std::vector<Vec3> points(6);
    for (Vec3& p : points) p = {place(random), place(random), place(random)};
    bool expected = false;
    for (std::size_t c = 0; c < 3; ++c) {
      expected = expected ||
                 pierces(points[c], points[(c + 1) % 3], {points[3], points[4], points[5]}) ||
                 pierces(points[3 + c], points[3 + (c + 1) % 3], {points[0], points[1], points[2]});
    }
    meeting += expected ? 1 : 0;
    ASSERT_EQ(meet_in(points, {0, 1, 2}, {3, 4, 5}), expected) << round;
  }
  EXPECT_GT(meeting, 1000);
  EXPECT_LT(meeting, 19000);
}

TEST(MeshCrossing, CountsThePairsOfAMesh) {
  const auto pairs = [](const Mesh& mesh) {
    return meeting_pairs(mesh, MeshTree(mesh, std::vector<std::uint32_t>(mesh.triangles.size())));
  };
  const Mesh torus = test::torus_mesh({0, 0, 0}, 3, 1, 60, 30);
  EXPECT_EQ(pairs(torus), 0U);
  const Mesh two = test::joined(torus, test::torus_mesh({3, 0.01, 0.02}, 3, 1, 50, 28));
  std::size_t expected = 0;
  for (std::size_t a = 0; a < two.triangles.size(); ++a) {
    for (std::size_t b = a + 1; b < two.triangles.size(); ++b) {
      expected += meet(box_of(two, a), box_of(two, b)) && triangles_meet(two, a, b) ? 1 : 0;
    }
  }
  EXPECT_GT(expected, 50U);
  EXPECT_EQ(pairs(two), expected);
}

}  // namespace
}  // namespace isoloop
