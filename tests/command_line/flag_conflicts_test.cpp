// Flags that contradict each other or the file, and values that make no sense, kept out by the
// built executable with one short sentence.
#include <string>

#include "tests/command_line/fixture.h"
#include "tests/samples/mesh_samples.h"

namespace isoloop {
namespace {

class FlagConflicts : public CommandLine {
 protected:
  FlagConflicts() { scratch_.write(ring_, ring_bytes()); }

  void expect_refusal(const Words& arguments, const std::string& words) const {
    expect_failure(arguments, 2, words);
    const std::string sentence = run(arguments).err;
    EXPECT_LT(sentence.size(), 300U) << sentence;
  }

  const std::string ring_ = "ring_5x5x3_uint8.raw";
};

TEST_F(FlagConflicts, LabelsHaveNoIsoValue) {
  for (const char* command : {"count", "loops"})
    expect_refusal({command, ring_, "--iso", "1", "--label", "1"},
                   "--iso does not go with --label");
  expect_refusal({"view", ring_, "--label", "1", "--iso", "1", "-o", "p.html"}, "--label");
  expect_refusal({"repair", ring_, "--label", "1", "--iso", "1", "--genus", "0", "--dry-run"},
                 "--label");
  expect_refusal({"scan", ring_, "--label", "1"}, "--label");
}

TEST_F(FlagConflicts, AFlagForOtherKindsOfFileIsRefused) {
  expect_refusal({"count", ring_, "--iso", "1", "--frame", "0"}, "--frame means nothing for");
  expect_refusal({"count", ring_, "--iso", "1", "--channel", "0"}, "--channel means nothing for");
  expect_refusal({"info", ring_, "--grid", "density"}, "--grid");
  expect_refusal({"count", ring_, "--iso", "1", "--series", "1"}, "--series");
  expect_refusal({"count", ring_, "--iso", "1", "--affine", "sform"}, "--affine");
  expect_refusal({"count", ring_, "--iso", "1", "--resolution", "9"}, "--resolution");
  scratch_.write("a.npy", "x");
  for (const Words& flag : {Words{"--dims", "5", "5", "3"}, Words{"--type", "u8"},
                            Words{"--endian", "little"}, Words{"--skip", "0"}}) {
    Words arguments{"count", "a.npy", "--iso", "1"};
    arguments.insert(arguments.end(), flag.begin(), flag.end());
    expect_refusal(arguments, flag[0] + " means nothing for a.npy: it is for raw files");
  }
  scratch_.write("a.off",
                 test::mesh_bytes(test::box_mesh({0, 0, 0}, {1, 1, 1}), test::MeshFormat::off));
  expect_refusal({"count", "a.off", "--resolution", "9", "--spacing", "2"}, "--voxel");
  expect_refusal({"count", "a.off", "--resolution", "9", "--label", "1"}, "--label");
  expect_refusal({"count", "a.off", "--resolution", "9", "--crop", ":,:,:"}, "--crop");
}

TEST_F(FlagConflicts, AnOutputWantsAName) {
  for (const char* flag : {"--json", "--csv", "--ply", "--html", "--curves", "--surface",
                           "--labels", "--dump-pairs"}) {
    expect_refusal({"loops", ring_, "--iso", "1", flag, ""}, flag);
  }
  for (const char* flag : {"--json", "--csv", "--svg"})
    expect_refusal({"scan", ring_, flag, ""}, flag);
  expect_refusal({"count", ring_, "--iso", "1", "--json", ""}, "--json");
  expect_refusal({"view", ring_, "--iso", "1", "-o", ""}, "--output");
  expect_refusal({"repair", ring_, "--iso", "1", "--genus", "0", "-o", ""}, "--output");
  expect_refusal({"repair", ring_, "--iso", "1", "--genus", "0", "--dry-run", "--json", ""},
                 "--json");
  expect_refusal({"generate", "torus", "-o", ""}, "--output");
  expect_refusal({"info", ""}, "FILE");
}

TEST_F(FlagConflicts, AnEmptyTextIsNoValue) {
  for (const char* flag : {"--label", "--crop", "--dims", "--spacing", "--type", "--grid",
                           "--series", "--max-memory", "--max-voxels", "--iso"}) {
    expect_refusal({"count", ring_, "--iso", "1", flag, ""}, flag);
  }
}

TEST_F(FlagConflicts, ACountIsWantedInAFewWords) {
  struct Case {
    Words arguments;
    const char* flag;
    std::vector<const char*> values;
  };
  for (const Case& one : std::vector<Case>{
           {{"count", "a.off"}, "--resolution", {"-5", "0", "1.5", "many", "1e300", "Auto"}},
           {{"count", "a.off"}, "--voxel", {"-5", "0", "nan", "inf", "1e999"}},
           {{"loops", ring_}, "--threads", {"-1", "0", "1025", "99999999999999999999"}},
           {{"scan", ring_}, "--values", {"-1", "0", "65001", "x"}},
           {{"view", ring_, "-o", "p.html"}, "--triangles", {"-1", "0"}},
           {{"count", ring_}, "--max-voxels", {"-1", "0", "1.5"}},
           {{"count", ring_}, "--skip", {"-1"}},
           {{"count", ring_}, "--frame", {"-1"}},
           {{"count", ring_}, "--channel", {"-1"}},
           {{"repair", ring_, "--dry-run"}, "--genus", {"-1"}},
           {{"generate", "plate", "-o", "x.raw"}, "--holes", {"-2", "1001"}},
           {{"generate", "plate", "-o", "x.raw"}, "--size", {"0", "-1"}},
           {{"generate", "lattice", "-o", "x.raw"}, "--cells", {"0", "-1", "101"}}}) {
    for (const char* value : one.values) {
      Words arguments = one.arguments;
      arguments.insert(arguments.end(), {one.flag, value});
      expect_refusal(arguments, std::string(one.flag) + ": ");
      EXPECT_NE(run(arguments).err.find("is wanted"), std::string::npos) << run(arguments).err;
    }
  }
}

TEST_F(FlagConflicts, ListsHaveSomethingBetweenTheirCommas) {
  for (const char* labels : {"3,,4", "3,", ",3", "1.5"})
    expect_refusal({"count", ring_, "--label", labels}, std::string("--label ") + labels);
  for (const char* ids : {"h1,", "h1,,t1", ",h1"}) {
    expect_refusal({"repair", ring_, "--iso", "1", "--dry-run", "--ids", ids}, "--ids");
  }
}

TEST_F(FlagConflicts, ACropLiesInTheVolume) {
  for (const char* crop : {"0:6,:,:", "-1:3,:,:", "3:3,:,:", ":,:,3:"})
    expect_refusal({"count", ring_, "--iso", "1", "--crop", crop}, "5 x 5 x 3 voxels");
  for (const char* crop : {"1:2", "1:2,3:4", "a:b,:,:", ":,:,:,:"})
    expect_refusal({"count", ring_, "--iso", "1", "--crop", crop}, "three ranges");
  expect_refusal({"repair", ring_, "--iso", "1", "--genus", "0", "--dry-run", "--crop", ":,:,:"},
                 "--crop does not go with repair");
}

}  // namespace
}  // namespace isoloop
