// --iso auto, and what scan proposes, by the built executable.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/command_line/fixture.h"
#include "tests/samples/real_data.h"

namespace isoloop {
namespace {

class AutoIso : public CommandLine {
 protected:
  Json json_of(Words arguments) const {
    arguments.insert(arguments.end(), {"--json", "-", "--quiet"});
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? Json::parse(result.out) : Json();
  }

  /// Sizes of the ten widest tunnels, the widest first; an infinite one is 1e9.
  static std::vector<double> widest_tunnels(const Json& json) {
    std::vector<double> sizes;
    for (const Json& loop : json.at("loops"))
      if (loop.at("kind") == "tunnel")
        sizes.push_back(loop.at("size").is_null() ? 1e9 : loop.at("size").get<double>());
    std::sort(sizes.begin(), sizes.end(), std::greater<>());
    sizes.resize(std::min<std::size_t>(sizes.size(), 10));
    return sizes;
  }
};

TEST_F(AutoIso, IsKnownToAllCommandsThatTakeIsoAndSaidInTheirReports) {
  const std::string file = testing::data("volumes/fuel_64x64x64_uint8.raw");
  ISOLOOP_NEEDS("volumes/fuel_64x64x64_uint8.raw");
  const std::string said = "chosen by --iso auto: the middle of the most stable plateau, 11 to 17";
  for (const Words& arguments :
       {Words{"count", file, "--iso", "auto"}, Words{"loops", file, "--iso", "auto"},
        Words{"view", file, "--iso", "auto", "-o", "p.html"},
        Words{"repair", file, "--iso", "auto", "--genus", "7", "--dry-run"}}) {
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("f >= 14, " + said), std::string::npos)
        << arguments[0] << ": " << result.out.substr(0, 300);
  }
  EXPECT_NE(scratch_.read("p.html").find(said), std::string::npos);
  for (const Words& arguments :
       {Words{"count", file, "--iso", "auto"}, Words{"loops", file, "--iso", "auto"},
        Words{"repair", file, "--iso", "auto", "--genus", "7", "--dry-run"}}) {
    const Json json = json_of(arguments);
    EXPECT_EQ(json.at("iso"), 14.0);
    EXPECT_NE(json.at("input").at("notes").dump().find(said), std::string::npos) << arguments[0];
  }
}

TEST_F(AutoIso, TakesTheMiddleOfAMaskAndTheSurfaceOfALevelSet) {
  scratch_.write("ring_5x5x3_uint8.raw", ring_bytes());
  EXPECT_EQ(json_of({"count", "ring_5x5x3_uint8.raw", "--iso", "auto"}).at("iso"), 0.5);
  ASSERT_EQ(run({"generate", "torus", "--size", "16", "-o", "t.vdb"}).exit_code, 0);
  const Json json = json_of({"count", "t.vdb", "--iso", "auto"});
  EXPECT_EQ(json.at("iso"), 0.0);
  EXPECT_EQ(json.at("betti").at("b1"), 1);
}

TEST_F(AutoIso, NamesTheLabelsOfALabelMap) {
  std::string labels(125, '\0');
  labels[62] = '\3';
  labels[63] = '\7';
  scratch_.write("labels_5x5x5_uint8.raw", labels);
  const std::string words = "0, 3, 7 alone, as in a label map: --label N[,M...]";
  expect_failure({"count", "labels_5x5x5_uint8.raw", "--iso", "auto"}, 2, words);
  expect_failure({"count", "labels_5x5x5_uint8.raw"}, 2, words);
  const ProcessResult scanned = run({"scan", "labels_5x5x5_uint8.raw"});
  EXPECT_EQ(scanned.exit_code, 0) << scanned.err;
  EXPECT_NE(scanned.out.find("no iso value is proposed"), std::string::npos) << scanned.out;
  EXPECT_NE(scanned.out.find(words), std::string::npos) << scanned.out;
  scratch_.write("flat_2x2x2_uint8.raw", std::string(8, '\5'));
  expect_failure({"count", "flat_2x2x2_uint8.raw", "--iso", "auto"}, 2, "all voxels are 5");
}

TEST_F(AutoIso, IgnoresWhatScanIsToldToIgnore) {
  const std::string name = "volumes/fuel_64x64x64_uint8.raw";
  ISOLOOP_NEEDS(name);
  const Json json = json_of({"scan", testing::data(name), "--ignore-below", "64"});
  EXPECT_EQ(json.at("ignored_below"), 64);
  const Json share = json_of({"scan", testing::data(name), "--ignore-below", "2%"});
  EXPECT_GT(share.at("ignored_below").get<int>(), 1);
  expect_failure({"scan", testing::data(name), "--ignore-below", "some"}, 2, "--ignore-below some");
}

TEST_F(AutoIso, TakesTheWoodOfABonsai) {
  const std::string name = "volumes/bonsai_256x256x256_uint8.nii.gz";
  ISOLOOP_NEEDS(name);
  const double iso = json_of({"scan", testing::data(name)}).at("proposed_iso");
  EXPECT_GE(iso, 37);
  EXPECT_LE(iso, 43);
}

// The solid at the proposed value has the ten widest tunnels of the solid that people mean, each
// no narrower than by a third. Where its README states a range of values, the nearest one counts.
TEST_F(AutoIso, KeepsTheTenWidestTunnelsThatPeopleMean) {
  struct Known {
    const char* file;
    double from;
    double to;
  };
  for (const Known& known : {Known{"volumes/fuel_64x64x64_uint8.raw", 15, 15},
                             Known{"volumes/hydrogen_128x128x128_uint8.raw", 15, 15},
                             Known{"volumes/silicium_98x34x34_uint8.raw", 85, 85},
                             Known{"volumes/nucleon_41x41x41_uint8.raw", 140, 140},
                             Known{"volumes/engine_half_128x128x64_uint8.raw", 60, 80}}) {
    ISOLOOP_NEEDS(known.file);
    const std::string file = testing::data(known.file);
    const Words rest{"--tighten", "none", "--side", "tunnel"};
    const auto loops = [&](const std::string& iso) {
      Words arguments{"loops", file, "--iso", iso};
      arguments.insert(arguments.end(), rest.begin(), rest.end());
      return json_of(arguments);
    };
    const Json chosen = loops("auto");
    const double iso = chosen.at("iso");
    const double meant = std::clamp(iso, known.from, known.to);
    if (meant == iso) continue;
    const Json mean = loops(std::to_string(meant));
    const std::vector<double> kept = widest_tunnels(chosen);
    const std::vector<double> wanted = widest_tunnels(mean);
    ASSERT_GE(kept.size(), wanted.size()) << known.file;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_GT(kept[i], wanted[i] * 2 / 3) << known.file << ' ' << i;
    if (mean.at("betti").at("b0") <= 4) {  // more are specks
      EXPECT_EQ(chosen.at("betti").at("b0"), mean.at("betti").at("b0")) << known.file;
    }
  }
}

}  // namespace
}  // namespace isoloop
