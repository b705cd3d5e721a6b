// Meshes by the built executable: their own counts beside those of the voxels.
#include <array>
#include <string>

#include "tests/command_line/fixture.h"
#include "tests/samples/contains.h"
#include "tests/samples/mesh_samples.h"
#include "tests/samples/real_data.h"

namespace isoloop {
namespace {

using test::box_mesh;
using test::contains;
using test::joined;

class MeshCommand : public CommandLine {
 protected:
  MeshCommand() {
    const Mesh boxes = joined(box_mesh({0, 0, 0}, {4, 1, 1}), box_mesh({0, 1.03, 0}, {4, 2, 1}));
    scratch_.write("boxes.stl", test::mesh_bytes(boxes, test::MeshFormat::stl_binary));
    Mesh open = boxes;
    open.triangles.pop_back();
    scratch_.write("open.off", test::mesh_bytes(open, test::MeshFormat::off));
  }
};

TEST_F(MeshCommand, WhereVoxelsLoseAGapTheMeshSaysSo) {
  for (const Words& command : {Words{"count", "boxes.stl"}, Words{"loops", "boxes.stl"},
                               Words{"view", "boxes.stl", "-o", "page.html"},
                               Words{"repair", "boxes.stl", "--genus", "0", "--dry-run"}}) {
    Words arguments = command;
    arguments.insert(arguments.end(), {"--resolution", "40"});
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(contains(result.err,
                         "isoloop: warning: boxes.stl: the voxels have 1 component, 0 tunnels, 0 "
                         "cavities, but the mesh itself 2 components, 0 tunnels, 0 cavities"))
        << command[0] << result.err;
    EXPECT_TRUE(
        contains(result.err, "try --voxel 0.015, half the least gap between two shells (0.03)"))
        << result.err;
  }
  const ProcessResult table = run({"count", "boxes.stl", "--resolution", "40"});
  EXPECT_TRUE(contains(table.out,
                       "\nmesh        2 components, 0 tunnels, 0 cavities by its 24 triangles in 2 "
                       "shells: the voxels have others\n"))
      << table.out;
}

TEST_F(MeshCommand, TheVoxelsThatAreProposedAgree) {
  const ProcessResult result = run({"count", "boxes.stl", "--voxel", "0.015", "--json", "-"});
  EXPECT_EQ(result.err, "");
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["betti"]["b0"], 2);
  EXPECT_EQ(json["input"]["mesh"]["betti"], json["betti"]);
  EXPECT_EQ(json["input"]["mesh"]["voxels_agree"], true);
}

TEST_F(MeshCommand, AutoRefinesUntilTheyAgree) {
  const ProcessResult result = run({"count", "boxes.stl", "--resolution", "auto"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(contains(result.out, "24 triangles in 2 shells: the voxels have the same\n"))
      << result.out;
  EXPECT_TRUE(contains(result.out, "note        --resolution auto took 128")) << result.out;
  const ProcessResult limited =
      run({"count", "boxes.stl", "--resolution", "auto", "--max-voxels", "100000"});
  EXPECT_EQ(limited.exit_code, 0) << limited.err;
  EXPECT_TRUE(contains(limited.err, "--resolution auto took 64, the nearest")) << limited.err;
  EXPECT_FALSE(contains(limited.err, "half the")) << limited.err;
  expect_failure({"count", "boxes.stl", "--resolution", "auto", "--max-voxels", "1000"}, 4,
                 "--max-voxels");
  expect_failure({"count", "boxes.stl", "--resolution", "auto", "--voxel", "1"}, 2, "--resolution");
}

TEST_F(MeshCommand, AnOpenMeshHasNoCountsOfItsOwn) {
  const ProcessResult result = run({"count", "open.off", "--resolution", "40"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "mesh        no counts of its own, because it is open\n"))
      << result.out;
  EXPECT_FALSE(contains(result.err, "but the mesh itself")) << result.err;
}

TEST_F(MeshCommand, InfoPrintsTheMesh) {
  const ProcessResult result = run({"info", "boxes.stl", "--resolution", "40"});
  EXPECT_TRUE(contains(result.out, "\nmesh       2 components, 0 tunnels, 0 cavities by its 24"))
      << result.out;
}

TEST_F(MeshCommand, OddMeshesComeOutRight) {
  const auto count = [&](const std::string& name, const char* resolution) {
    const std::string file =
        std::filesystem::absolute(isoloop::testing::data("odd/" + name)).string();
    return run({"count", file, "--resolution", resolution, "--json", "-"});
  };
  const auto betti = [](const Json& json) {
    return std::array<int, 3>{json["b0"].get<int>(), json["b1"].get<int>(), json["b2"].get<int>()};
  };
  ISOLOOP_NEEDS("odd/close_rings.stl");
  const ProcessResult rings = count("close_rings.stl", "128");
  EXPECT_TRUE(contains(rings.err, "the mesh itself 2 components, 2 tunnels, 0 cavities"))
      << rings.err;
  ISOLOOP_NEEDS("odd/hollow_torus_last_bits.stl");
  const ProcessResult hollow = count("hollow_torus_last_bits.stl", "128");
  EXPECT_TRUE(contains(hollow.err, "were taken to be one")) << hollow.err;
  const Json json = Json::parse(hollow.out);
  EXPECT_EQ(betti(json["betti"]), (std::array{1, 2, 1}));
  EXPECT_EQ(betti(json["input"]["mesh"]["betti"]), (std::array{1, 2, 1}));
}

}  // namespace
}  // namespace isoloop
