#include "tools/runs/mesh_comparison.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/samples/contains.h"
#include "tests/samples/sample_run.h"
#include "tools/reports/report_json.h"

namespace isoloop {
namespace {

using test::contains;

/// The torus, b0 1, b1 1, b2 0 by its voxels of length 0.5, as made from a mesh of these counts.
LoopsRun run_of(const Betti& betti) {
  LoopsRun run = torus_run();
  run.file = "rings.stl";
  run.level = {.iso = 0.0, .inside = InsideRule::below};
  run.volume.mesh = MeshCounts{.triangles = 36, .shells = 2, .betti = betti};
  return run;
}

std::string difference(const LoopsRun& run) { return difference_text(run, run.analysis); }

TEST(MeshComparison, NamesBothCountsAndSmallerVoxels) {
  LoopsRun run = run_of({.b0 = 2, .b1 = 2, .b2 = 0});
  EXPECT_EQ(voxels_agree(run, run.analysis), false);
  EXPECT_EQ(
      difference(run),
      "rings.stl: the voxels have 1 component, 1 tunnel, 0 cavities, but the mesh itself 2 "
      "components, 2 tunnels, 0 cavities: walls, gaps or sharp edges are finer than voxels of 0.5; "
      "try --voxel 0.25, half the present length, or --resolution auto");
  run.volume.mesh->gap = 0.125;
  EXPECT_TRUE(contains(difference(run),
                       "try --voxel 0.0625, half the least gap between two shells (0.125), or"))
      << difference(run);
}

TEST(MeshComparison, IsSilentWhereNothingDiffers) {
  const LoopsRun run = run_of({.b0 = 1, .b1 = 1, .b2 = 0});
  EXPECT_EQ(voxels_agree(run, run.analysis), true);
  EXPECT_EQ(difference(run), "");
  EXPECT_FALSE(voxels_agree(torus_run(), torus_run().analysis));
}

TEST(MeshComparison, IsSilentWhereNothingIsKnown) {
  const LoopsRun differs = run_of({.b0 = 2, .b1 = 2, .b2 = 0});
  const auto expect_silence = [](const LoopsRun& run) {
    EXPECT_FALSE(voxels_agree(run, run.analysis));
    EXPECT_EQ(difference(run), "");
  };
  LoopsRun run = differs;
  run.volume.mesh->betti = std::nullopt;
  expect_silence(run);
  run = differs;
  run.level.iso = 0.5;
  expect_silence(run);
  run = differs;
  run.level.upper = 1.0;
  expect_silence(run);
  run = differs;
  run.level.inside = InsideRule::above;
  expect_silence(run);
  run = differs;
  run.analysis.surface.boundary = Boundary::open;
  expect_silence(run);
}

TEST(MeshComparison, IsSaidOnceWhereTheRefinementSaidIt) {
  LoopsRun run = run_of({.b0 = 2, .b1 = 2, .b2 = 0});
  run.volume.mesh->voxels = run.analysis.betti;
  EXPECT_EQ(difference(run), "");
  run.volume.mesh->voxels->b1 = 7;  // counted otherwise, as with --topology simple
  EXPECT_NE(difference(run), "");
}

TEST(MeshComparison, IsInTheJson) {
  LoopsRun run = run_of({.b0 = 2, .b1 = 2, .b2 = 0});
  run.volume.mesh->gap = 0.125;
  EXPECT_EQ(mesh_json(run, run.analysis).dump(),
            R"({"triangles":36,"shells":2,"swallowed":0,"betti":{"b0":2,"b1":2,"b2":0},)"
            R"("unknown":null,"gap":0.125,"voxels_agree":false})");
  run.volume.mesh = MeshCounts{.triangles = 36, .unknown = "it is open"};
  EXPECT_EQ(mesh_json(run, run.analysis).dump(),
            R"({"triangles":36,"shells":null,"swallowed":null,"betti":null,)"
            R"("unknown":"it is open","gap":null,"voxels_agree":null})");
  EXPECT_TRUE(mesh_json(torus_run(), torus_run().analysis).is_null());
}

TEST(MeshComparison, TextsSayWhatIsKnown) {
  MeshCounts mesh{.triangles = 36, .shells = 3, .betti = Betti{.b0 = 2, .b1 = 1, .b2 = 0}};
  EXPECT_EQ(mesh_text(mesh), "2 components, 1 tunnel, 0 cavities by its 36 triangles in 3 shells");
  mesh.swallowed = 1;
  EXPECT_TRUE(contains(mesh_text(mesh), "(1 within the solid, so not counted)"));
  EXPECT_EQ(mesh_text({.triangles = 36, .unknown = "it is open"}),
            "no counts of its own, because it is open");
}

}  // namespace
}  // namespace isoloop
