// Promises of `isoloop loops --features` and `--labels`, kept by the built executable.
#include <cstring>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/command_line/fixture.h"

namespace isoloop {
namespace {

class FeaturesCommand : public CommandLine {
 protected:
  FeaturesCommand() {
    EXPECT_EQ(run({"generate", "torus", "--size", "32", "-o", "torus.nrrd"}).exit_code, 0);
  }

  ProcessResult loops(Words more) const {
    const Words words{"loops", "torus.nrrd", "--inside", "below", "--iso", "0"};
    more.insert(more.begin(), words.begin(), words.end());
    return run(more);
  }

  std::set<int> labels_of(const std::string& nrrd) const {
    const std::string bytes = scratch_.read(nrrd);
    std::set<int> labels;
    for (std::size_t at = bytes.find("\n\n") + 2; at + 1 < bytes.size(); at += 2) {
      std::uint16_t label = 0;
      std::memcpy(&label, bytes.data() + at, 2);
      labels.insert(label);
    }
    return labels;
  }
};

TEST_F(FeaturesCommand, AreMeasuredInTheTableTheJsonAndTheCsv) {
  const ProcessResult result =
      loops({"--features", "--json", "t.json", "--csv", "t.csv", "--ply", "t.ply"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("\nfeatures\nid  kind    label"), std::string::npos) << result.out;
  const Json json = Json::parse(scratch_.read("t.json"));
  const Json handle = json["loops"][0]["feature"];
  // The tube's girth is that of the loop; on so fat a ring fronts slant before they get round.
  const double girth = json["loops"][0]["length"];
  EXPECT_NEAR(handle["least_girth"], girth, 0.1 * girth);
  EXPECT_NEAR(handle["thickness"].get<double>() * 3.14159, handle["least_girth"], 1e-3);
  EXPECT_GT(handle["depth"], 0.7 * girth);
  EXPECT_LT(handle["depth"], 2 * girth);
  EXPECT_EQ(handle["label"], 1);
  EXPECT_EQ(json["loops"][1]["feature"]["label"], 2);
  EXPECT_NE(scratch_.read("t.csv").find("certificate_outside,label,area"), std::string::npos);
  EXPECT_NE(scratch_.read("t.ply").find("property int label\n"), std::string::npos);
}

TEST_F(FeaturesCommand, AreLeftOutUnlessAskedFor) {
  const ProcessResult result = loops({"--json", "t.json", "--ply", "t.ply", "--html", "t.html"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out.find("\nfeatures\n"), std::string::npos);
  EXPECT_FALSE(Json::parse(scratch_.read("t.json"))["loops"][0].contains("feature"));
  EXPECT_EQ(scratch_.read("t.ply").find("property int label\n"), std::string::npos);
  EXPECT_NE(scratch_.read("t.html").find("\"feature\":{"), std::string::npos)
      << "the page has them";
}

TEST_F(FeaturesCommand, GrowWithTheRatio) {
  const auto area = [&](const std::string& ratio) {
    const ProcessResult result = loops({"--feature-ratio", ratio, "--json", "-"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(result.out)["loops"][1]["feature"]["area"].get<double>();
  };
  EXPECT_LT(area("1.2"), area("1.6"));
}

TEST_F(FeaturesCommand, LabelVolumesReadBackInTheFrameOfTheInput) {
  const ProcessResult result = loops({"--labels", "l.nrrd", "--labels", "l.vdb"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json input = Json::parse(
      run({"count", "torus.nrrd", "--inside", "below", "--iso", "0", "--json", "-"}).out)["input"];
  const ProcessResult read = run({"count", "l.nrrd", "--iso", "1", "--json", "-"});
  ASSERT_EQ(read.exit_code, 0) << read.err;
  const Json labels = Json::parse(read.out);
  for (const char* field : {"dims", "spacing", "origin", "direction"})
    EXPECT_EQ(labels["input"][field], input[field]) << field;
  EXPECT_EQ(labels["input"]["type"], "uint16");
  EXPECT_EQ(labels["betti"]["b0"], 1) << "features of a torus touch";
  EXPECT_EQ(labels_of("l.nrrd"), (std::set<int>{0, 1, 2}));
  const ProcessResult grid =
      run({"count", "l.vdb", "--grid", "labels", "--iso", "1", "--json", "-"});
  ASSERT_EQ(grid.exit_code, 0) << grid.err;
  EXPECT_EQ(Json::parse(grid.out)["betti"], labels["betti"]);
}

TEST_F(FeaturesCommand, OfTheReportedLoopsAreLabelled) {
  ASSERT_EQ(loops({"--side", "tunnel", "--labels", "l.nrrd"}).exit_code, 0);
  EXPECT_EQ(labels_of("l.nrrd"), (std::set<int>{0, 2}));
}

TEST_F(FeaturesCommand, RefuseWhatMakesNoSense) {
  const Words torus{"loops", "torus.nrrd", "--inside", "below", "--iso", "0"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), torus.begin(), torus.end());
    return more;
  };
  expect_failure(with({"--features", "--open-boundary"}), 2, "--open-boundary");
  expect_failure(with({"--feature-ratio", "0.5"}), 2, "from 1 on");
  expect_failure(with({"--feature-ratio", "inf"}), 2, "from 1 on");
  expect_failure(with({"--feature-ratio", "nan"}), 2, "from 1 on");
  expect_failure(with({"--labels", "l.tif"}), 2, "written as .raw, .nii");
  expect_failure(with({"--labels", "-"}), 2, "written as .raw, .nii");
  expect_failure(with({"--labels", "torus.nrrd"}), 2, "would overwrite the input");
  expect_failure(with({"--labels", "l.raw", "--labels", "l.raw"}), 2, "another output");
}

}  // namespace
}  // namespace isoloop
