// What the built executable makes of masks, label maps, parts of volumes and untidy files.
#include <array>
#include <string>

#include "tests/command_line/fixture.h"
#include "tests/samples/byte_samples.h"
#include "tests/samples/contains.h"
#include "tests/samples/npy_samples.h"
#include "tests/samples/real_data.h"

namespace isoloop {
namespace {

using test::contains;
using testing::data;

class UntidyInput : public CommandLine {
 protected:
  UntidyInput() { scratch_.write(ring_, ring_bytes()); }

  Json json_of(Words arguments) const {
    arguments.insert(arguments.end(), {"--json", "-"});
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? Json::parse(result.out) : Json();
  }

  std::array<int, 3> betti_of(const Words& arguments) const {
    const Json betti = json_of(arguments).at("betti");
    return {betti.at("b0"), betti.at("b1"), betti.at("b2")};
  }

  const std::string ring_ = "ring_5x5x3_uint8.raw";
};

TEST_F(UntidyInput, AMaskIsSaidToBeOneByEveryCommand) {
  const std::string flags = "--label 1 --connectivity 26";
  for (const Words& arguments :
       {Words{"count", ring_, "--iso", "1"}, Words{"loops", ring_, "--iso", "1"},
        Words{"view", ring_, "--iso", "1", "-o", "p.html"}, Words{"scan", ring_},
        Words{"info", ring_}}) {
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(contains(result.out, flags)) << arguments[0] << result.out;
    EXPECT_TRUE(contains(result.out, "0 and 1 alone")) << arguments[0] << result.out;
  }
  const ProcessResult counted = run({"count", ring_, "--iso", "1"});
  EXPECT_TRUE(contains(counted.out, "which gives 1 component, 1 tunnel and 0 cavities"))
      << counted.out;
  const Json json = json_of({"count", ring_, "--iso", "1"});
  EXPECT_TRUE(contains(json.at("input").at("notes").dump(), flags));
  EXPECT_TRUE(contains(json_of({"scan", ring_}).at("input").at("notes").dump(), flags));
}

TEST_F(UntidyInput, AMaskThatIsReadAsOneNeedsNoHint) {
  for (const Words& arguments : {Words{"count", ring_, "--label", "1"},
                                 Words{"count", ring_, "--iso", "1", "--connectivity", "26"},
                                 Words{"info", ring_, "--label", "1"}}) {
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_FALSE(contains(result.out, "--connectivity 26")) << result.out;
  }
}

TEST_F(UntidyInput, TheMissingIsoOfAMaskOrLabelMapNamesTheLabels) {
  expect_failure({"count", ring_}, 2, "--label 1 --connectivity 26");
  std::string labels = ring_bytes();
  labels[0] = 2;
  labels[1] = 5;
  scratch_.write("map_5x5x3_uint8.raw", labels);
  expect_failure({"count", "map_5x5x3_uint8.raw"}, 2, "0, 1, 2, 5");
  expect_failure({"count", "map_5x5x3_uint8.raw"}, 2, "--label N");
}

TEST_F(UntidyInput, BoolsNeedNoIsoValue) {
  scratch_.write("ring.npy", test::npy_header("|b1", "(3, 5, 5)") + ring_bytes());
  EXPECT_EQ(betti_of({"count", "ring.npy"}), (std::array{1, 1, 0}));
  EXPECT_EQ(json_of({"count", "ring.npy"}).at("iso"), 0.5);
}

TEST_F(UntidyInput, APartOfAVolumeIsReportedAsOneAndStaysInItsPlace) {
  ASSERT_EQ(run({"generate", "torus", "--size", "40", "-o", "t.nrrd"}).exit_code, 0);
  const Words flags{"t.nrrd", "--iso", "0", "--inside", "below"};
  const auto with = [&](const Words& more) {
    Words arguments{"loops"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  const Json whole = json_of(with({}));
  EXPECT_TRUE(whole.at("input").at("part").is_null());
  const Json same = json_of(with({"--crop", "1:,1:,:"}));
  EXPECT_EQ(same.at("input").at("part").at("first"), Json::parse("[1,1,0]"));
  EXPECT_EQ(same.at("input").at("part").at("of"), whole.at("input").at("dims"));
  EXPECT_EQ(same.at("betti"), whole.at("betti"));
  EXPECT_EQ(same.at("input").at("origin"), Json::parse("[1.0,1.0,0.0]"));
  const Json all = json_of(with({"--crop", ":,:,:"}));
  EXPECT_EQ(all.at("loops"), whole.at("loops"));
  const Json half = json_of(with({"--crop", ":20,:,:"}));
  EXPECT_EQ(half.at("betti").at("b1"), 0);
  const ProcessResult table = run({"count", ring_, "--iso", "1", "--crop", "1:4,:,1:2"});
  EXPECT_TRUE(table.out.starts_with(
      "ring_5x5x3_uint8.raw: 3 x 5 x 1 uint8 (voxels 1:4,0:5,1:2 of 5 x 5 x 3), inside is f >= 1"))
      << table.out;
  EXPECT_TRUE(contains(run({"info", ring_, "--crop", "1:4,:,1:2"}).out, "voxels 1:4,0:5,1:2 of"));
  EXPECT_TRUE(contains(run({"scan", ring_, "--crop", "1:4,:,1:2"}).out, "voxels 1:4,0:5,1:2 of"));
}

TEST_F(UntidyInput, OddFilesComeOutRight) {
  const auto expect = [&](const std::string& name, Words flags, const std::array<int, 3>& betti) {
    ISOLOOP_NEEDS("odd/" + name);
    Words arguments{"count", data("odd/" + name)};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    EXPECT_EQ(betti_of(arguments), betti) << name;
  };
  constexpr std::array parts{2, 3, 1};
  expect("labels_not_whole.nii.gz", {"--label", "1"}, parts);
  expect("labels_below.nii.gz", {"--label", "1"}, parts);
  expect("cell_data.vti", {"--iso", "0.5"}, parts);
  expect("77 %.mhd", {"--iso", "0.5"}, parts);
  expect("skeleton_mask.npy", {"--label", "255", "--connectivity", "26"}, {1, 3, 0});
}

TEST_F(UntidyInput, OddFilesAreReadWithAWordOfWhatWasAssumed) {
  const auto run_on = [&](const std::string& name, const Words& flags) {
    Words arguments{"count", data("odd/" + name)};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    return run(arguments);
  };
  for (const char* name : {"loopy_Plate1_1.stl", "cinolib_torus.obj", "count0.stl"}) {
    ISOLOOP_NEEDS("odd/" + std::string(name));
    const ProcessResult result = run_on(name, {"--resolution", "64"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(contains(result.err, "isoloop: warning: ")) << name << result.err;
  }
  ISOLOOP_NEEDS("odd/one_partial_block.vti");
  EXPECT_EQ(run_on("one_partial_block.vti", {"--iso", "0.5"}).exit_code, 0);
  ISOLOOP_NEEDS("odd/skeleton_mask.npy");
  const ProcessResult mask = run_on("skeleton_mask.npy", {"--iso", "128"});
  EXPECT_TRUE(contains(mask.out, "--label 255 --connectivity 26")) << mask.out;
  EXPECT_TRUE(contains(mask.out, "1 component, 3 tunnels and 0 cavities")) << mask.out;
}

}  // namespace
}  // namespace isoloop
