#include "volume/mesh_topology/mesh_counts.h"

#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/base/threads.h"
#include "tests/samples/mesh_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/mesh_topology/mesh_gap.h"

namespace isoloop {
namespace {

using test::block_mesh;
using test::box_mesh;
using test::contains;
using test::flipped;
using test::joined;
using test::torus_mesh;

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

MeshCounts counts_of(const Mesh& mesh, double near = 1.0) {
  return count_mesh(mesh, near, no_limit);
}

/// b0, b1, b2; or why not.
std::string answer(const Mesh& mesh) {
  const MeshCounts counts = counts_of(mesh);
  EXPECT_EQ(counts.betti.has_value(), counts.unknown.empty());
  return counts.betti ? betti_text(*counts.betti) : counts.unknown;
}

/// By angles that make no coordinate of the samples equal another.
Mesh turned(Mesh mesh) {
  for (Vec3& p : mesh.points) {
    p = {0.8 * p[0] - 0.6 * p[1], 0.6 * p[0] + 0.8 * p[1], p[2]};
    p = {p[0], 0.28 * p[1] - 0.96 * p[2], 0.96 * p[1] + 0.28 * p[2]};
  }
  return mesh;
}

const Mesh cube = box_mesh({0, 0, 0}, {10, 10, 10});

TEST(MeshCounts, AreThoseOfTheSolid) {
  for (const bool turn : {false, true}) {
    const auto expect = [&](const Mesh& mesh, const char* text) {
      EXPECT_EQ(answer(turn ? turned(mesh) : mesh), text) << (turn ? "turned" : "upright");
    };
    expect(cube, "b0 1, b1 0, b2 0");
    expect(torus_mesh({0, 0, 0}, 3, 1, 40, 20), "b0 1, b1 1, b2 0");
    expect(block_mesh(2), "b0 1, b1 2, b2 0");
    expect(block_mesh(5), "b0 1, b1 5, b2 0");
    expect(joined(cube, box_mesh({10.1, 0, 0}, {20, 10, 10})), "b0 2, b1 0, b2 0");
    expect(joined(cube, flipped(box_mesh({3, 3, 3}, {7, 7, 7}))), "b0 1, b1 0, b2 1");
    expect(joined(cube, flipped(torus_mesh({5, 5, 5}, 2.5, 1, 24, 12))), "b0 1, b1 1, b2 1");
    const Mesh hollow = joined(cube, flipped(box_mesh({1, 1, 1}, {9, 9, 9})));
    expect(joined(hollow, box_mesh({3, 3, 3}, {7, 7, 7})), "b0 2, b1 0, b2 1");
  }
}

TEST(MeshCounts, AShellWithinTheSolidThatFacesTheSameWayBoundsNothing) {
  const MeshCounts counts = counts_of(joined(cube, torus_mesh({5, 5, 5}, 2.5, 1, 24, 12)));
  ASSERT_TRUE(counts.betti);
  EXPECT_EQ(betti_text(*counts.betti), "b0 1, b1 0, b2 0");
  EXPECT_EQ(counts.shells, 2U);
  EXPECT_EQ(counts.swallowed, 1U);
}

TEST(MeshCounts, AMeshInsideOutIsTheSameSolid) {
  const Mesh hollow = joined(cube, flipped(torus_mesh({5, 5, 5}, 2.5, 1, 24, 12)));
  EXPECT_EQ(answer(flipped(hollow)), "b0 1, b1 1, b2 1");
}

TEST(MeshCounts, WhereFacesDisagreeShellsCountByEvenAndOdd) {
  Mesh mesh = joined(joined(cube, box_mesh({1, 1, 1}, {9, 9, 9})), box_mesh({3, 3, 3}, {7, 7, 7}));
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  EXPECT_EQ(answer(mesh), "b0 2, b1 0, b2 1");
}

TEST(MeshCounts, AreUnknownWhereTheMeshBoundsNoSolidOfItsOwn) {
  Mesh open = cube;
  open.triangles.pop_back();
  EXPECT_EQ(answer(open), "it is open");
  // Two boxes that share an edge: it has four faces.
  const auto shared = [](const Mesh& mesh) {
    return parse_mesh(test::mesh_bytes(mesh, test::MeshFormat::off), MeshKind::off, "a.off");
  };
  EXPECT_EQ(answer(shared(joined(cube, box_mesh({10, 10, 0}, {20, 20, 10})))),
            "parts of it touch: 1 edge has more than two faces");
  EXPECT_EQ(answer(shared(joined(cube, box_mesh({10, 10, 10}, {20, 20, 20})))),
            "parts of it touch at 1 corner");
  EXPECT_TRUE(contains(answer(joined(cube, box_mesh({10, 2, 2}, {12, 8, 8}))), "touches itself"));
  EXPECT_TRUE(contains(answer(joined(cube, box_mesh({9, 2, 2}, {12, 8, 8}))), "crosses or"));
  EXPECT_TRUE(
      contains(answer(turned(joined(cube, torus_mesh({10, 5, 5}, 2.5, 1, 24, 12)))), "crosses or"));
}

TEST(MeshCounts, AShellFoldedFlatIsUnknown) {
  const Mesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  EXPECT_TRUE(contains(answer(flat), "touches itself")) << answer(flat);
}

TEST(MeshCounts, TheGapIsTheLeastDistanceBetweenShells) {
  const Mesh boxes = joined(cube, box_mesh({10.125, 2, 2}, {20, 8, 8}));
  ASSERT_TRUE(counts_of(boxes).gap);
  EXPECT_DOUBLE_EQ(*counts_of(boxes).gap, 0.125);
  EXPECT_FALSE(counts_of(boxes, 0.125).gap);  // not nearer than that
  EXPECT_FALSE(counts_of(cube).gap);
  ASSERT_TRUE(counts_of(turned(boxes)).gap);
  EXPECT_NEAR(*counts_of(turned(boxes)).gap, 0.125, 1e-12);
}

TEST(MeshCounts, HoldToTheirLimit) {
  const MeshCounts counts = count_mesh(cube, 1.0, 1000);
  EXPECT_FALSE(counts.betti);
  EXPECT_TRUE(contains(counts.unknown, "more memory")) << counts.unknown;
}

/// Boxes on a lattice, some within others and some inside out, numbered by chance.
TEST(MeshCounts, EqualTheCountsOfManyNestedShells) {
  std::mt19937 random(11);
  for (int round = 0; round < 20; ++round) {
    Mesh mesh;
    std::int64_t solids = 0;
    std::int64_t cavities = 0;
    for (int cell = 0; cell < 27; ++cell) {
      const auto along = [&](int step) { return static_cast<double>(10 * (cell / step % 3)); };
      const Vec3 low{along(1), along(3), along(9)};
      const auto depth = static_cast<int>(random() % 5);
      for (int d = 0; d < depth; ++d) {
        const Mesh box = box_mesh({low[0] + d, low[1] + d, low[2] + d},
                                  {low[0] + 9 - d, low[1] + 9 - d, low[2] + 9 - d});
        mesh = joined(mesh, d % 2 == 0 ? box : flipped(box));
        ++(d % 2 == 0 ? solids : cavities);
      }
    }
    if (mesh.triangles.empty()) continue;
    const std::string expected = betti_text({.b0 = solids, .b1 = 0, .b2 = cavities});
    EXPECT_EQ(answer(mesh), expected);
    EXPECT_EQ(answer(turned(mesh)), expected);
  }
}

TEST(MeshCounts, AreTheSameForAnyNumberOfThreads) {
  Mesh mesh = joined(torus_mesh({0, 0, 0}, 3, 1, 200, 100), torus_mesh({0, 0, 2.2}, 3, 1, 150, 90));
  const MeshCounts first = counts_of(mesh);
  ASSERT_TRUE(first.gap);
  const Mesh crossing = joined(mesh, torus_mesh({2, 0, 1}, 3, 1, 170, 80));
  const std::string why = answer(crossing);
  EXPECT_TRUE(contains(why, "crosses")) << why;
  for (const int threads : {1, 2, 16}) {
    with_threads(threads, [&] {
      EXPECT_EQ(*counts_of(mesh).gap, *first.gap) << threads;
      EXPECT_EQ(answer(crossing), why) << threads;
      return 0;
    });
  }
}

TEST(MeshCountsData, AreThoseOfKnownMeshes) {
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"meshes/igl_fertility.off", "b0 1, b1 4, b2 0"},
           {"meshes/dir_eight.off", "b0 1, b1 2, b2 0"},
           {"meshes/loopy_kitten.obj", "b0 1, b1 1, b2 0"},
           {"meshes/vcg_knot_orig.ply", "b0 1, b1 1, b2 0"},
           {"meshes/dir_botijo.obj", "b0 1, b1 5, b2 0"},
           {"meshes/tetgentests_casting.off", "b0 1, b1 9, b2 0"},
           {"meshes/loopy_gyroidpuzzle.obj", "b0 1, b1 15, b2 0"},
           {"meshes/thingi10k_88566.stl", "b0 8, b1 32, b2 0"},
           {"odd/close_rings.stl", "b0 2, b1 2, b2 0"},
           {"odd/hollow_torus_last_bits.stl", "b0 1, b1 2, b2 1"},
           {"odd/count0.stl", "b0 1, b1 1, b2 0"},
           {"odd/cinolib_torus.obj", "b0 1, b1 1, b2 0"}}) {
    ISOLOOP_NEEDS(name);
    EXPECT_EQ(answer(read_mesh(test::data(name))), text) << name;
  }
}

TEST(MeshCountsData, GravgenCrossesItself) {
  ISOLOOP_NEEDS("meshes/cinolib_Gravgen.obj");
  const std::string why = answer(read_mesh(test::data("meshes/cinolib_Gravgen.obj")));
  EXPECT_TRUE(contains(why, "crosses or touches itself in 16")) << why;  // some 1 680 pairs
}

}  // namespace
}  // namespace isoloop
