#include "volume/voxelize/voxelize.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "core/base/errors.h"
#include "core/base/threads.h"
#include "tests/samples/mesh_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/voxelize/mesh_distance.h"
#include "volume/voxelize/mesh_winding.h"

namespace isoloop {
namespace {

using test::box_mesh;
using test::contains;
using test::flipped;
using test::joined;
using test::torus_mesh;

Volume at_length(const Mesh& mesh, double length) {
  return voxelize(mesh, {.length = length}, {}, "a.stl");
}

Betti betti_of(const Volume& volume) {
  return count_topology(view(volume), {0.0, InsideRule::below}).betti;
}

std::array<std::int64_t, 3> numbers(const Betti& betti) {
  return {static_cast<std::int64_t>(betti.b0), static_cast<std::int64_t>(betti.b1),
          static_cast<std::int64_t>(betti.b2)};
}

using Numbers = std::array<std::int64_t, 3>;

TEST(Voxelize, MeasuresDistancesInTheFrameOfTheMesh) {
  const Volume volume = at_length(box_mesh({100, 200, 300}, {104, 206, 308}), 0.5);
  EXPECT_TRUE(volume.level_set);
  EXPECT_EQ(volume.frame, Frame::world);
  EXPECT_EQ(volume.spacing, (Vec3{0.5, 0.5, 0.5}));
  EXPECT_TRUE(volume.warnings.empty());
  const auto& values = std::get<std::vector<float>>(volume.values);
  const auto out = [](double x, double low, double high) { return std::max(low - x, x - high); };
  std::size_t v = 0;
  for (std::int64_t k = 0; k < volume.dims[2]; ++k) {
    for (std::int64_t j = 0; j < volume.dims[1]; ++j) {
      for (std::int64_t i = 0; i < volume.dims[0]; ++i, ++v) {
        const Vec3 at = to_world(
            volume, {static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
        const Vec3 d{out(at[0], 100, 104), out(at[1], 200, 206), out(at[2], 300, 308)};
        const double inside = std::max({d[0], d[1], d[2]});
        const double outside =
            std::hypot(std::max(d[0], 0.0), std::max(d[1], 0.0), std::max(d[2], 0.0));
        const double expected = std::clamp(inside > 0 ? outside : inside, -1.5, 1.5);
        ASSERT_NEAR(values[v], expected, 2e-5) << i << ' ' << j << ' ' << k;
      }
    }
  }
  EXPECT_GT(values.front(), 0.0F);
}

TEST(Voxelize, ResolutionCountsVoxelsAlongTheLongestSide) {
  const Volume volume = voxelize(box_mesh({0, 0, 0}, {1, 2, 4}), {.resolution = 20}, {}, "a.stl");
  EXPECT_DOUBLE_EQ(volume.spacing[0], 0.2);
  EXPECT_EQ(volume.dims, (Index3{5 + 6, 10 + 6, 20 + 6}));
}

TEST(Voxelize, AShellWithinAnotherBoundsACavity) {
  const Mesh outer = box_mesh({0, 0, 0}, {10, 10, 10});
  const Mesh hollow = joined(outer, flipped(box_mesh({3, 3, 3}, {7, 7, 7})));
  const Volume volume = at_length(hollow, 0.5);
  EXPECT_EQ(numbers(betti_of(volume)), (Numbers{1, 0, 1}));
  EXPECT_TRUE(volume.warnings.empty());
  const Mesh torus_within = joined(outer, flipped(torus_mesh({5, 5, 5}, 2.5, 1, 24, 12)));
  EXPECT_EQ(numbers(betti_of(at_length(torus_within, 0.25))), (Numbers{1, 1, 1}));
}

TEST(Voxelize, AMeshInsideOutIsTheSameSolid) {
  const Mesh mesh = torus_mesh({0, 0, 0}, 3, 1, 40, 20);
  EXPECT_EQ(at_length(flipped(mesh), 0.25).values, at_length(mesh, 0.25).values);
  EXPECT_EQ(numbers(betti_of(at_length(mesh, 0.25))), (Numbers{1, 1, 0}));
}

TEST(Voxelize, PartsThatOverlapAreJoinedWithAWarning) {
  const Mesh two = joined(box_mesh({0, 0, 0}, {4, 4, 4}), box_mesh({2, 2, 2}, {6, 6, 6}));
  const Volume volume = at_length(two, 0.5);
  EXPECT_EQ(numbers(betti_of(volume)), (Numbers{1, 0, 0}));
  ASSERT_EQ(volume.warnings.size(), 1U);
  EXPECT_TRUE(contains(volume.warnings[0].text, "overlap")) << volume.warnings[0].text;
}

TEST(Voxelize, FacesThatDisagreeAreTakenByEvenAndOddWithAWarning) {
  Mesh mesh = box_mesh({0, 0, 0}, {4, 4, 4});
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  std::swap(mesh.triangles[8][0], mesh.triangles[8][1]);
  const Volume volume = at_length(mesh, 0.5);
  EXPECT_EQ(volume.values, at_length(box_mesh({0, 0, 0}, {4, 4, 4}), 0.5).values);
  ASSERT_EQ(volume.warnings.size(), 1U);
  EXPECT_TRUE(contains(volume.warnings[0].text, "odd number")) << volume.warnings[0].text;
}

TEST(Voxelize, AnOpenMeshIsFloodedWithAWarning) {
  Mesh mesh = box_mesh({0, 0, 0}, {4, 4, 4});
  Mesh cracked = mesh;  // a corner of one triangle moved by a tenth of a voxel
  cracked.points.push_back({0, 0, 0.05});
  cracked.triangles[0][0] = 8;
  const Volume solid = at_length(cracked, 0.5);
  EXPECT_EQ(numbers(betti_of(solid)), (Numbers{1, 0, 0}));
  ASSERT_EQ(solid.warnings.size(), 1U);
  EXPECT_TRUE(contains(solid.warnings[0].text, "the mesh is open (4 edges"))
      << solid.warnings[0].text;
  mesh.triangles.resize(10);  // a whole face is missing: the outside comes in
  EXPECT_NE(at_length(mesh, 0.5).values, solid.values);
}

TEST(Voxelize, AnObjFileCutBetweenItsShellsIsReadWithAWarning) {
  const Mesh boxes = test::joined(box_mesh({0, 0, 0}, {4, 4, 4}), box_mesh({6, 0, 0}, {9, 3, 3}));
  const std::string whole = test::mesh_bytes(boxes, test::MeshFormat::obj);
  const auto warnings = [](const std::string& bytes) {
    return at_length(parse_mesh(bytes, MeshKind::obj, "a.obj"), 0.5).warnings;
  };
  EXPECT_TRUE(warnings(whole).empty());
  const std::string cut = whole.substr(0, whole.find("f 9 "));
  ASSERT_LT(cut.size(), whole.size());
  ASSERT_EQ(warnings(cut).size(), 1U);
  EXPECT_TRUE(contains(warnings(cut)[0].text, "8 points are in no face")) << warnings(cut)[0].text;
}

TEST(Voxelize, AThinWallStaysWhereVoxelsAreSmaller) {
  const Mesh plate = box_mesh({0, 0, 0}, {8, 8, 0.3});
  EXPECT_EQ(numbers(betti_of(at_length(plate, 0.25))), (Numbers{1, 0, 0}));
  const Mesh tube =
      joined(box_mesh({0, 0, 0}, {8, 8, 8}), flipped(box_mesh({0.3, 0.3, 0.3}, {7.7, 7.7, 7.7})));
  EXPECT_EQ(numbers(betti_of(at_length(tube, 0.25))), (Numbers{1, 0, 1}));
}

TEST(Voxelize, RefusesSizesThatMakeNoVoxels) {
  const Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 4});
  const auto refused = [&](const VoxelSize& size) {
    const auto error = test::error_of<InvalidArgument>([&] { voxelize(mesh, size, {}, "a.stl"); });
    EXPECT_EQ(error.option, Option::voxel_size);
    return error.finding;
  };
  EXPECT_TRUE(contains(refused({}).text, "longest side is 4"));
  EXPECT_TRUE(test::advises(refused({.length = 1.0, .resolution = 4}), Advice::state_voxel_size));
  refused({.length = 0.0});
  refused({.length = -1.0});
  refused({.length = std::nan("")});
  refused({.length = 1e-300});
  refused({.resolution = 0});
  const Mesh point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}};
  EXPECT_THROW(voxelize(point, {.length = 1.0}, {}, "a.stl"), InvalidInput);
}

TEST(Voxelize, RefusesMeshesThatDoublesCannotHold) {
  const Mesh away = box_mesh({1e16, 0, 0}, {1e16 + 10, 1, 1});
  EXPECT_THROW(voxelize(away, {.length = 0.1}, {}, "a.stl"), InvalidInput);
  for (const double far : {1e200, 1e308, std::numeric_limits<double>::max()}) {
    const Mesh large = box_mesh({-far, -far / 2, 0}, {far, 0, 1});
    EXPECT_THROW(voxelize(large, {.resolution = 8}, {}, "a.stl"), InvalidInput) << far;
  }
}

TEST(Voxelize, ChecksTheLimitsBeforeItAllocates) {
  const Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  for (const double length : {1e-17, 1e-12, 1e-5}) {
    EXPECT_THROW(voxelize(mesh, {.length = length}, {}, "a.stl"), LimitExceeded) << length;
  }
  EXPECT_THROW(voxelize(mesh, {.resolution = 10}, {.max_bytes = 16383}, "a.stl"), LimitExceeded);
  EXPECT_NO_THROW(voxelize(mesh, {.resolution = 10}, {.max_bytes = 16384}, "a.stl"));
  EXPECT_THROW(voxelize(mesh, {.resolution = 10}, {.max_voxels = 4095}, "a.stl"), LimitExceeded);
}

/// Solid angles by van Oosterom and Strackee: the number of times that the mesh winds round p.
double solid_angle_winding(const Mesh& mesh, const Vec3& p) {
  double sum = 0.0;
  for (const auto& triangle : mesh.triangles) {
    std::array<Vec3, 3> r{};
    std::array<double, 3> length{};
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t a = 0; a < 3; ++a) r[c][a] = mesh.points[triangle[c]][a] - p[a];
      length[c] = std::hypot(r[c][0], r[c][1], r[c][2]);
    }
    const auto dot = [&](std::size_t i, std::size_t j) {
      return r[i][0] * r[j][0] + r[i][1] * r[j][1] + r[i][2] * r[j][2];
    };
    const double det = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) -
                       r[0][1] * (r[1][0] * r[2][2] - r[1][2] * r[2][0]) +
                       r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
    sum += 2.0 * std::atan2(det, length[0] * length[1] * length[2] + dot(0, 1) * length[2] +
                                     dot(1, 2) * length[0] + dot(2, 0) * length[1]);
  }
  return sum / (4.0 * 3.141592653589793);
}

TEST(MeshWinding, EqualsSolidAnglesOnRandomSolids) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(3.0, 9.0);
  const Index3 dims{13, 12, 14};
  for (int round = 0; round < 60; ++round) {
    Mesh mesh;
    for (int part = 0; part < 3; ++part) {
      Mesh more = round % 2 == 0
                      ? torus_mesh({place(random), place(random), place(random)}, 2.0, 0.9, 7, 5)
                      : box_mesh({1, 1, place(random)}, {8, place(random), 11});
      // Corners on voxel centres and edges along rows of voxels are where the ties are.
      if (round % 3 == 0) {
        for (Vec3& p : more.points) p = {std::round(p[0]), std::round(p[1]), std::round(p[2])};
      }
      mesh = joined(mesh, (random() & 1U) != 0 ? flipped(more) : more);
    }
    const std::vector<float> distances = unsigned_distances(mesh, mesh.points, dims);
    std::vector<float> values(distances.size(), 1.0F);
    negate_inside(values, dims, mesh, mesh.points, InsideOf::winding, 1U << 30, "mesh");
    std::size_t v = 0;
    for (std::int64_t k = 0; k < dims[2]; ++k) {
      for (std::int64_t j = 0; j < dims[1]; ++j) {
        for (std::int64_t i = 0; i < dims[0]; ++i, ++v) {
          const double turns = solid_angle_winding(
              mesh, {static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
          // Undecided on the mesh itself, which corners moved by 1/8192 of a voxel can pass.
          if (distances[v] < 1e-3F) continue;
          ASSERT_EQ(values[v]<0.0F, std::abs(turns)> 0.5)
              << "round " << round << " at " << i << ' ' << j << ' ' << k;
        }
      }
    }
  }
}

TEST(Voxelize, GivesTheSameBytesForAnyNumberOfThreads) {
  const Mesh mesh = torus_mesh({0, 0, 0}, 3, 1, 200, 100);
  const Volume first = at_length(mesh, 0.05);
  for (const int threads : {1, 2, 16}) {
    for (int run = 0; run < 3; ++run) {
      const Volume again = with_threads(threads, [&] { return at_length(mesh, 0.05); });
      EXPECT_EQ(again.values, first.values) << threads << " threads";
    }
  }
}

/// Genus g, found as g handle loops and g tunnel loops.
void expect_genus(const std::string& name, std::int64_t resolution, std::size_t genus) {
  const Mesh mesh = read_mesh(test::data(name));
  const Volume volume = voxelize(mesh, {.resolution = resolution}, {}, name);
  EXPECT_TRUE(volume.warnings.empty()) << name;
  const Analysis analysis = analyze(view(volume), {0.0, InsideRule::below});
  std::size_t handles = 0;
  for (const Loop& loop : analysis.loops) handles += loop.kind == LoopKind::handle ? 1 : 0;
  EXPECT_EQ(handles, genus) << name;
  EXPECT_EQ(analysis.loops.size() - handles, genus) << name;
}

TEST(Voxelize, FertilityHasGenus4) {
  ISOLOOP_NEEDS("meshes/igl_fertility.off");
  expect_genus("meshes/igl_fertility.off", 64, 4);
}

TEST(Voxelize, EightHasGenus2) {
  ISOLOOP_NEEDS("meshes/dir_eight.off");
  expect_genus("meshes/dir_eight.off", 64, 2);
}

TEST(Voxelize, KittenHasGenus1) {
  ISOLOOP_NEEDS("meshes/loopy_kitten.obj");
  expect_genus("meshes/loopy_kitten.obj", 64, 1);
}

TEST(Voxelize, KnotHasGenus1) {
  ISOLOOP_NEEDS("meshes/vcg_knot_orig.ply");
  expect_genus("meshes/vcg_knot_orig.ply", 64, 1);
}

TEST(Voxelize, BotijoHasGenus5) {
  ISOLOOP_NEEDS("meshes/dir_botijo.obj");
  expect_genus("meshes/dir_botijo.obj", 64, 5);
}

}  // namespace
}  // namespace isoloop
