// Promises of `isoloop convert`, kept by the built executable.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/command_line/fixture.h"
#include "tests/samples/mesh_samples.h"

namespace isoloop {
namespace {

using Json = nlohmann::json;

class ConvertCommand : public CommandLine {
 protected:
  ConvertCommand() { scratch_.write(ring_, ring_bytes()); }

  Json count_of(const std::string& file, const Words& flags) const {
    Words words{"count", file, "--json", "-"};
    words.insert(words.end(), flags.begin(), flags.end());
    const ProcessResult result = run(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(result.out);
  }

  const std::string ring_ = "ring_5x5x3_uint8.raw";
};

TEST_F(ConvertCommand, KeepsVoxelsTypeAndPlaceThroughEveryFormat) {
  std::string from = ring_;
  Words flags{"--spacing", "0.5", "0.25", "2mm"};
  for (const std::string to : {"a.nrrd", "b.nii.gz", "c.mha", "d.nii", "e.vti"}) {
    Words words{"convert", from, to};
    words.insert(words.end(), flags.begin(), flags.end());
    const ProcessResult result = run(words);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, to + ": 5 x 5 x 3 uint8\n");
    const Json counted = count_of(to, {"--iso", "1"});
    EXPECT_EQ(counted["betti"]["b1"], 1);
    EXPECT_EQ(counted["input"]["type"], "uint8") << to;
    EXPECT_EQ(counted["input"]["spacing"], (std::vector<double>{0.5, 0.25, 2.0})) << to;
    from = to;
    flags.clear();
  }
  const ProcessResult back = run({"convert", "e.vti", "back_5x5x3_uint8.raw"});
  ASSERT_EQ(back.exit_code, 0) << back.err;
  EXPECT_NE(back.err.find("says nothing of where voxels lie"), std::string::npos) << back.err;
  EXPECT_EQ(scratch_.read("back_5x5x3_uint8.raw"), ring_bytes());
  ASSERT_EQ(run({"convert", ring_, "f.npy"}).exit_code, 0);
  ASSERT_EQ(run({"convert", "f.npy", "again_5x5x3_uint8.raw"}).err, "");
  EXPECT_EQ(scratch_.read("again_5x5x3_uint8.raw"), ring_bytes());
}

TEST_F(ConvertCommand, AddsNoLayerToWhatAVdbFileHolds) {
  ASSERT_EQ(run({"convert", ring_, "a.vdb"}).exit_code, 0);
  const ProcessResult back = run({"convert", "a.vdb", "b.npy"});
  // Voxels of the background at the border are not active.
  EXPECT_EQ(back.out.find("b.npy: 3 x 3 x 1"), 0U) << back.out;
}

TEST_F(ConvertCommand, LeavesTheVoxelsBesideAHeaderAsTheyAre) {
  scratch_.write("ring.nhdr",
                 "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 5 5 3\nencoding: raw\n"
                 "data file: ring.raw\n\n");
  scratch_.write("ring.raw", ring_bytes());
  for (const Words& words :
       {Words{"convert", "ring.nhdr", "ring.raw"},
        Words{"count", "ring.nhdr", "--iso", "1", "--json", "ring.raw"},
        Words{"repair", "ring.nhdr", "--iso", "1", "--genus", "0", "-o", "ring.raw"}})
    expect_failure(words, 2, "ring.raw would overwrite the input's file of voxels");
  EXPECT_EQ(scratch_.read("ring.raw"), ring_bytes());
}

TEST_F(ConvertCommand, SaysWhatTheOtherFormatCannotSay) {
  ASSERT_EQ(run({"convert", ring_, "a.nii", "--spacing", "0.5mm"}).err, "");
  const ProcessResult moved = run({"convert", "a.nii", "b.mha"});
  EXPECT_NE(moved.err.find("coordinates in a .mha file are LPS"), std::string::npos) << moved.err;
  EXPECT_NE(moved.err.find("cannot state that lengths are in mm"), std::string::npos) << moved.err;
  const ProcessResult mesh_like = run({"convert", "b.mha", "c.vti"});
  EXPECT_NE(mesh_like.err.find("does not say that its coordinates are LPS"), std::string::npos)
      << mesh_like.err;
}

TEST_F(ConvertCommand, TakesLabelsPartsPipesAndMeshes) {
  ASSERT_EQ(run({"convert", ring_, "mask.npy", "--label", "1"}).exit_code, 0);
  EXPECT_EQ(count_of("mask.npy", {})["betti"]["b1"], 1) << "bools need no iso value";
  ASSERT_EQ(run({"convert", ring_, "part.nrrd", "--crop", "0:5,0:5,1:2"}).exit_code, 0);
  EXPECT_EQ(count_of("part.nrrd", {"--iso", "1"})["input"]["dims"], (std::vector<int>{5, 5, 1}));
  scratch_.write("box.off",
                 test::mesh_bytes(test::box_mesh({0, 0, 0}, {1, 1, 1}), test::MeshFormat::off));
  const ProcessResult voxels = run({"convert", "box.off", "box.vdb", "--resolution", "16"});
  ASSERT_EQ(voxels.exit_code, 0) << voxels.err;
  EXPECT_EQ(count_of("box.vdb", {})["betti"]["b0"], 1);
}

TEST_F(ConvertCommand, RefusesWhatItCannotWriteBeforeItReads) {
  expect_failure({"convert", "missing.nrrd", "out.stl"}, 2, "OUT out.stl: volumes are written as");
  expect_failure({"convert", ring_, ring_}, 2, "would overwrite the input");
  expect_failure({"convert", ring_, "out_5x5x4_uint8.raw"}, 2, "name it so");
  expect_failure({"convert", ring_}, 2, "OUT");
}

}  // namespace
}  // namespace isoloop
