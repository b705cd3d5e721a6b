// Promises of `isoloop repair`, kept by the built executable.
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/command_line/fixture.h"
#include "tests/samples/byte_samples.h"
#include "tests/samples/nifti_samples.h"

namespace isoloop {
namespace {

class RepairCommand : public CommandLine {
 protected:
  RepairCommand() { scratch_.write("ring_5x5x3_uint8.raw", ring_bytes()); }

  Json counts(const std::string& file) const {
    const ProcessResult result = run({"count", file, "--iso", "1", "--json", "-"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(result.out)["betti"];
  }

  /// The ring is a disc afterwards, of the same voxel type and at the same place.
  void expect_filled_in_place(const std::string& ring, const std::string& filled) const {
    const Json before = Json::parse(run({"count", ring, "--iso", "1", "--json", "-"}).out);
    const Json after = Json::parse(run({"count", filled, "--iso", "1", "--json", "-"}).out);
    EXPECT_EQ(before["betti"]["b1"], 1);
    EXPECT_EQ(after["betti"]["b1"], 0);
    for (const char* field : {"dims", "type", "spacing", "origin", "direction"})
      EXPECT_EQ(after["input"][field], before["input"][field]) << field;
    EXPECT_EQ(after["conventions"]["coordinates"], before["conventions"]["coordinates"]);
  }

  static std::size_t bytes_changed(const std::string& a, const std::string& b) {
    EXPECT_EQ(a.size(), b.size());
    std::size_t changed = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) changed += a[i] != b[i] ? 1 : 0;
    return changed;
  }

  const std::string ring_ = "ring_5x5x3_uint8.raw";
  const std::string out_ = "out_5x5x3_uint8.raw";
};

TEST_F(RepairCommand, FillsATunnelAndChangesNoOtherByte) {
  const ProcessResult result =
      run({"repair", ring_, "--iso", "1", "--ids", "t1", "-o", out_, "--json", "report.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json after = counts(out_);
  EXPECT_EQ(after["b0"], 1);
  EXPECT_EQ(after["b1"], 0);
  EXPECT_EQ(after["b2"], 0);
  const Json report = Json::parse(scratch_.read("report.json"));
  EXPECT_EQ(report["schema"], "isoloop-repair/1");
  EXPECT_EQ(report["changed_voxels"], bytes_changed(ring_bytes(), scratch_.read(out_)));
  EXPECT_EQ(report["cut_voxels"], 0);
  EXPECT_EQ(report["removals"][0]["action"], "fill");
  EXPECT_EQ(report["before"]["genus"], 1);
  EXPECT_EQ(report["after"]["genus"], 0);
  EXPECT_NE(result.out.find("tunnel 1"), std::string::npos) << result.out;
}

TEST_F(RepairCommand, CutsAHandle) {
  const ProcessResult result = run(
      {"repair", ring_, "--iso", "1", "--ids", "1", "--side", "handle", "-o", out_, "--json", "-"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(counts(out_)["b1"], 0);
  EXPECT_EQ(counts(out_)["b0"], 1);
  EXPECT_EQ(Json::parse(result.out)["filled_voxels"], 0);
}

TEST_F(RepairCommand, TwiceIsTheSameAsOnce) {
  ASSERT_EQ(run({"repair", ring_, "--iso", "1", "--auto", "100", "-o", out_}).exit_code, 0);
  const std::string again = "again_5x5x3_uint8.raw";
  const ProcessResult result = run({"repair", out_, "--iso", "1", "--auto", "100", "-o", again});
  EXPECT_NE(result.out.find("nothing to repair"), std::string::npos) << result.out;
  EXPECT_EQ(scratch_.read(again), scratch_.read(out_));
}

TEST_F(RepairCommand, ADryRunWritesNoVolume) {
  const Words before = scratch_.files();
  const ProcessResult result = run({"repair", ring_, "--iso", "1", "--genus", "0", "--dry-run"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("verified: genus 1 - 1 = 0"), std::string::npos) << result.out;
  EXPECT_EQ(scratch_.files(), before);
}

TEST_F(RepairCommand, KeepsTheTypeAndGeometryOfAnOpenVdbFile) {
  ASSERT_EQ(run({"generate", "torus", "--size", "20", "-o", "torus.vdb"}).exit_code, 0);
  const ProcessResult result = run({"repair", "torus.vdb", "--fill-tunnels", "100", "-o", "o.vdb"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json before = Json::parse(run({"count", "torus.vdb", "--json", "-"}).out);
  const Json after = Json::parse(run({"count", "o.vdb", "--json", "-"}).out);
  EXPECT_EQ(after["betti"]["b1"], 0);
  for (const char* field : {"dims", "type", "spacing", "origin", "direction", "level_set", "grid"})
    EXPECT_EQ(after["input"][field], before["input"][field]) << field;
}

TEST_F(RepairCommand, KeepsTheTypeAndGeometryOfAnNrrdFile) {
  scratch_.write("ring.nrrd",
                 "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\n"
                 "sizes: 5 5 3\nspace directions: (0,0.5,0) (-0.5,0,0) (0,0,2)\n"
                 "space origin: (1,-2,3.25)\nencoding: raw\n\n" +
                     ring_bytes());
  const ProcessResult result =
      run({"repair", "ring.nrrd", "--iso", "1", "--fill-tunnels", "100", "-o", "o.nrrd"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  expect_filled_in_place("ring.nrrd", "o.nrrd");
}

/// A NIfTI file of the ring, placed by its sform.
std::string nifti_ring(const std::string& magic) {
  test::NiftiSample sample;
  sample.dim = {3, 5, 5, 3, 1, 1, 1, 1};
  sample.type = 2;
  sample.bits = 8;
  sample.sform = 1;
  sample.rows = {0.5, 0, 0, -10, 0, 0.5, 0, 20, 0, 0, 2, 5};
  sample.magic = magic;
  if (magic.starts_with("ni1")) sample.from = 0;
  return sample.header();
}

TEST_F(RepairCommand, KeepsTheHeaderOfANiftiFile) {
  const std::string ring = nifti_ring({"n+1\0", 4}) + ring_bytes();
  scratch_.write("ring.nii", ring);
  scratch_.write("ring.nii.gz", test::gzip_bytes(ring));
  const Words flags{"--iso", "1", "--fill-tunnels", "100"};
  for (const std::string name : {"ring.nii", "ring.nii.gz"}) {
    Words command{"repair", name, "-o", "out_" + name, "--json", "report.json", "--quiet"};
    command.insert(command.end(), flags.begin(), flags.end());
    const ProcessResult result = run(command);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(counts("out_" + name)["b1"], 0) << name;
  }
  const Json report = Json::parse(scratch_.read("report.json"));
  EXPECT_EQ(report["changed_voxels"], bytes_changed(ring, scratch_.read("out_ring.nii")));
}

TEST_F(RepairCommand, WritesOtherFormatsWithTheGeometryOfTheInput) {
  scratch_.write("ring.nii", nifti_ring({"n+1\0", 4}) + ring_bytes());
  for (const Words& solid : {Words{"--iso", "1"}, Words{"--label", "1"}}) {
    Words command{"repair", "ring.nii", "--genus", "0", "-o", "out.nrrd"};
    command.insert(command.end(), solid.begin(), solid.end());
    const ProcessResult result = run(command);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    expect_filled_in_place("ring.nii", "out.nrrd");
  }
}

TEST_F(RepairCommand, WritesAnewWhatCannotBeCopiedAndSaysWhatThatLeavesOut) {
  scratch_.write("ring.hdr", nifti_ring({"ni1\0", 4}));
  scratch_.write("ring.img", ring_bytes());
  for (const std::string half : {".hdr", ".img"})
    expect_failure({"repair", "ring" + half, "--iso", "1", "--genus", "0", "-o", "out" + half}, 2,
                   "volumes are written as");
  std::string wide = "NRRD0004\ntype: int64\ndimension: 3\nsizes: 5 5 3\nendian: little\n";
  wide += "encoding: raw\n\n";
  for (const char voxel : ring_bytes()) wide += voxel + std::string(7, '\0');
  scratch_.write("wide.nrrd", wide);
  const ProcessResult result =
      run({"repair", "wide.nrrd", "--iso", "1", "--genus", "0", "-o", "out.nrrd"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("out.nrrd is written anew"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("its voxels are int32"), std::string::npos) << result.err;
  EXPECT_EQ(counts("out.nrrd")["b1"], 0);
  expect_failure({"repair", "ring.nii", "--iso", "1", "--genus", "0", "-o", "out.tif"}, 3, "ring");
  scratch_.write("ring.nii", nifti_ring({"n+1\0", 4}) + ring_bytes());
  expect_failure({"repair", "ring.nii", "--iso", "1", "--genus", "0", "-o", "out.tif"}, 2,
                 "volumes are written as .raw, .nii, .nii.gz, .nrrd, .mha, .npy, .vti or .vdb");
}

TEST_F(RepairCommand, KeepsTheOtherLabelsOfALabelMap) {
  // A ring of 7, a voxel of 3 in its hole, and a voxel of 5 apart.
  std::string labels = ring_bytes();
  for (char& voxel : labels) voxel = voxel != 0 ? '\7' : '\0';
  const std::size_t hole = 2 + 5 * (2 + 5 * 1);
  ASSERT_EQ(labels[hole], '\0');
  labels[0] = '\5';
  std::string filled = labels;
  filled[hole] = '\7';
  scratch_.write("labels_5x5x3_int8.raw", labels);
  for (const std::string out : {"out_5x5x3_int8.raw", "out.nrrd", "out.nii.gz", "out.vdb"}) {
    const ProcessResult result = run(
        {"repair", "labels_5x5x3_int8.raw", "--label", "7", "--fill-tunnels", "100", "-o", out});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err.find("another label"), std::string::npos) << result.err;
    ASSERT_EQ(run({"convert", out, "back_5x5x3_int8.raw"}).exit_code, out == "out.vdb" ? 2 : 0);
    if (out != "out.vdb") {
      EXPECT_EQ(scratch_.read("back_5x5x3_int8.raw"), filled) << out;
    }
    const Json after = Json::parse(run({"count", out, "--label", "7", "--json", "-"}).out);
    EXPECT_EQ(after["betti"]["b1"], 0) << out;
    const Json other = Json::parse(run({"count", out, "--label", "5", "--json", "-"}).out);
    EXPECT_EQ(other["betti"]["b0"], 1) << out;
  }
  const ProcessResult absent = run({"repair", "labels_5x5x3_int8.raw", "--label", "300,7",
                                    "--fill-tunnels", "100", "-o", "absent_5x5x3_int8.raw"});
  ASSERT_EQ(absent.exit_code, 0) << absent.err;
  EXPECT_EQ(scratch_.read("absent_5x5x3_int8.raw"), filled) << "300 does not even fit";
  labels[hole] = '\3';
  scratch_.write("labels_5x5x3_int8.raw", labels);
  const ProcessResult over = run({"repair", "labels_5x5x3_int8.raw", "--label", "7",
                                  "--fill-tunnels", "100", "-o", "over_5x5x3_int8.raw"});
  ASSERT_EQ(over.exit_code, 0) << over.err;
  EXPECT_NE(over.err.find("voxels filled that had another label than 0: 1"), std::string::npos)
      << over.err;
  EXPECT_EQ(scratch_.read("over_5x5x3_int8.raw"), filled);
}

TEST_F(RepairCommand, RefusesWhatMakesNoSense) {
  const Words repair{"repair", ring_, "--iso", "1"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), repair.begin(), repair.end());
    return more;
  };
  expect_failure(with({"-o", out_}), 2, "nothing to repair is named");
  expect_failure(with({"--genus", "0"}), 2, "--output");
  expect_failure(with({"--genus", "0", "-o", ring_}), 2, "would overwrite the input");
  expect_failure(with({"--genus", "0", "-o", "out.tif"}), 2, "volumes are written as");
  expect_failure(with({"--inside", "below", "--genus", "0", "-o", "out.vdb"}), 2,
                 "a layer of its least value lies round the voxels, and here that is inside");
  expect_failure(with({"--ids", "1", "-o", out_}), 2, "h1 or t1");
  expect_failure(with({"--ids", "h2", "-o", out_}), 2, "there is no handle 2");
  expect_failure(with({"--ids", "x", "--side", "handle", "-o", out_}), 2, "'x' is no id");
  expect_failure(with({"--fill-tunnels", "0", "-o", out_}), 2, "--fill-tunnels");
  expect_failure(with({"--genus", "0", "-o", out_, "--open-boundary"}), 2, "open boundary");
}

}  // namespace
}  // namespace isoloop
