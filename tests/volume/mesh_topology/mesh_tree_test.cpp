#include "volume/mesh_topology/mesh_tree.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/samples/mesh_samples.h"

namespace isoloop {
namespace {

TEST(MeshTree, LeadsToEveryTriangleOnce) {
  for (const std::uint32_t around : {3U, 4U, 5U, 7U, 12U, 90U}) {
    const Mesh mesh = test::torus_mesh({0, 0, 0}, 3, 1, around, 3 + around / 7);
    const MeshTree tree(mesh, std::vector<std::uint32_t>(mesh.triangles.size()));
    std::multiset<std::uint32_t> seen;
    tree.walk([](const Box&, std::uint32_t) { return true; },
              [&](std::uint32_t t) { seen.insert(t); });
    EXPECT_EQ(seen.size(), mesh.triangles.size());
    EXPECT_EQ(std::set<std::uint32_t>(seen.begin(), seen.end()).size(), seen.size());
  }
}

TEST(MeshTree, BoxesHoldTheirTrianglesAndNameTheirShell) {
  const Mesh one = test::torus_mesh({0, 0, 0}, 3, 1, 40, 20);
  const Mesh mesh = test::joined(one, test::torus_mesh({9, 0, 0}, 3, 1, 40, 20));
  std::vector<std::uint32_t> shells(mesh.triangles.size(), 7);
  std::fill(shells.begin() + static_cast<std::ptrdiff_t>(one.triangles.size()), shells.end(), 9);
  const MeshTree tree(mesh, shells);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 13) {
    const Box box = box_of(mesh, t);
    std::set<std::uint32_t> found;
    tree.walk([&](const Box& other, std::uint32_t) { return meet(box, other); },
              [&](std::uint32_t other) {
                if (meet(box, box_of(mesh, other))) found.insert(other);
              });
    std::set<std::uint32_t> expected;
    for (std::uint32_t other = 0; other < mesh.triangles.size(); ++other) {
      if (meet(box, box_of(mesh, other))) expected.insert(other);
    }
    EXPECT_EQ(found, expected);
  }
  std::size_t in_nine = 0;
  tree.walk([](const Box&, std::uint32_t shell) { return shell != 7; },
            [&](std::uint32_t t) { in_nine += shells[t] == 9 ? 1 : 0; });
  EXPECT_EQ(in_nine, mesh.triangles.size() - one.triangles.size());
}

}  // namespace
}  // namespace isoloop
