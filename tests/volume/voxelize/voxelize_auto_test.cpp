#include "volume/voxelize/voxelize_auto.h"

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "core/base/errors.h"
#include "tests/samples/mesh_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/files/read.h"
#include "volume/mesh_topology/mesh_counts.h"

namespace isoloop {
namespace {

using test::box_mesh;
using test::contains;
using test::joined;

const Mesh close_boxes = joined(box_mesh({0, 0, 0}, {4, 1, 1}), box_mesh({0, 1.012, 0}, {4, 2, 1}));

Volume refined(const Mesh& mesh, const VoxelLimits& limits = {}) {
  return voxelize_until_counts_agree(mesh, {.automatic = true}, limits, "a.stl");
}

std::string counts_of(const Volume& volume) {
  return betti_text(count_topology(view(volume), {0.0, InsideRule::below}).betti);
}

TEST(VoxelizeAuto, TakesTheFirstResolutionThatHasTheCountsOfTheMesh) {
  const Volume volume = refined(close_boxes);
  EXPECT_EQ(counts_of(volume), "b0 2, b1 0, b2 0");
  EXPECT_TRUE(volume.warnings.empty());
  ASSERT_EQ(volume.notes.size(), 1U);
  EXPECT_TRUE(contains(volume.notes[0].text, "took 256: the voxels have at 64 b0 1"))
      << volume.notes[0].text;
  EXPECT_EQ(volume.notes[0].about, Option::automatic_resolution);
  EXPECT_DOUBLE_EQ(volume.spacing[0], 4.0 / 256);
  const Volume same = voxelize(close_boxes, {.resolution = 256}, {}, "a.stl");
  EXPECT_EQ(volume.values, same.values);
  const Volume coarse = refined(box_mesh({0, 0, 0}, {4, 1, 1}));
  EXPECT_DOUBLE_EQ(coarse.spacing[0], 4.0 / 64);
}

TEST(VoxelizeAuto, SaysWhichLimitEndsIt) {
  const Volume volume = refined(close_boxes, {.max_voxels = 1'000'000});
  EXPECT_DOUBLE_EQ(volume.spacing[0], 4.0 / 128);
  ASSERT_EQ(volume.warnings.size(), 1U);
  for (const char* part :
       {"took 128, the nearest", "at 128 b0 1, b1 0, b2 0", "the mesh itself b0 2, b1 0, b2 0"}) {
    EXPECT_TRUE(contains(volume.warnings[0].text, part)) << volume.warnings[0].text;
  }
  EXPECT_TRUE(test::advises(volume.warnings[0], Advice::raise_voxel_limit));
  const Volume memory = refined(close_boxes, {.max_bytes = 3'000'000});
  ASSERT_EQ(memory.warnings.size(), 1U);
  EXPECT_TRUE(test::advises(memory.warnings[0], Advice::raise_memory_limit));
  EXPECT_THROW(refined(close_boxes, {.max_voxels = 1000}), LimitExceeded);
}

TEST(VoxelizeAuto, TakesTwoEqualCountsWhereTheMeshHasNone) {
  Mesh open = box_mesh({0, 0, 0}, {4, 1, 1});
  open.points.push_back({0, 0, 0.001});
  open.triangles[0][0] = 8;
  const Volume volume = refined(open);
  EXPECT_DOUBLE_EQ(volume.spacing[0], 4.0 / 128);
  ASSERT_EQ(volume.warnings.size(), 2U);
  EXPECT_TRUE(contains(volume.warnings[1].text, "because it is open")) << volume.warnings[1].text;
}

TEST(VoxelizeAuto, GoesWithNoOtherSize) {
  const test::TempFolder folder;
  test::write_bytes(folder / "a.off", test::mesh_bytes(close_boxes, test::MeshFormat::off));
  EXPECT_THROW(read_volume(folder / "a.off", {.voxel_size = {.length = 1.0, .automatic = true}}),
               InvalidArgument);
  EXPECT_EQ(counts_of(read_volume(folder / "a.off", {.voxel_size = {.automatic = true}})),
            "b0 2, b1 0, b2 0");
  test::write_bytes(folder / "a_1x1x1_uint8.raw", "a");
  EXPECT_THROW(read_volume(folder / "a_1x1x1_uint8.raw", {.voxel_size = {.automatic = true}}),
               InvalidArgument);
}

TEST(VoxelizeAutoData, CloseRingsAreTwo) {
  ISOLOOP_NEEDS("odd/close_rings.stl");
  const Volume volume =
      read_volume(test::data("odd/close_rings.stl"), {.voxel_size = {.automatic = true}});
  EXPECT_EQ(counts_of(volume), "b0 2, b1 2, b2 0");
}

}  // namespace
}  // namespace isoloop
