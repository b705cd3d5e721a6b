#include "tools/page/page.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/samples/sample_run.h"

namespace isoloop {
namespace {

std::string page_of(const LoopsRun& run) {
  std::ostringstream out;
  write_page(out, run);
  return out.str();
}

nlohmann::json data_in(const std::string& page) {
  const std::string head = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(head) + head.size();
  return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(Page, HoldsTheSurfaceTheLoopsAndTheVolume) {
  const auto data = data_in(page_of(torus_run()));
  EXPECT_EQ(data["mesh"]["triangles"], 18);
  EXPECT_EQ(data["mesh"]["positions"].get<std::string>().size(), 4 * 9 * 6 / 3);
  ASSERT_EQ(data["loops"].size(), 2U);
  EXPECT_EQ(data["loops"][0]["kind"], "handle");
  EXPECT_EQ(data["loops"][1]["size"], nullptr) << "infinite";
  EXPECT_EQ(data["loops"][0]["curves"][0].get<std::string>().size(), 4 * 3 * 6 / 3);
  EXPECT_EQ(data["volume"]["dims"], (std::vector<int>{10, 10, 10}));
  EXPECT_EQ(data["volume"]["block"], 1);
}

/// The numbers of points that the page's script reads.
std::vector<int> points_of(const nlohmann::json& feature) {
  static const std::string letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::size_t> bytes;
  std::size_t bits = 0;
  std::size_t count = 0;
  for (const char c : feature["points"].get<std::string>()) {
    if (c == '=') break;
    bits = bits << 6 | letters.find(c);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(bits >> count & 0xFF);
  }
  std::vector<int> points;
  int at = 0;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    at += static_cast<int>(bytes[i]);
    for (std::size_t n = 0; n < bytes[i + 1]; ++n) points.push_back(at++);
  }
  return points;
}

TEST(Page, SaysWhichPointsLieInTheFeatures) {
  const auto data = data_in(page_of(torus_run_with_features()));
  const auto& handle = data["loops"][0]["feature"];
  EXPECT_EQ(handle["depth"], 1.5);
  EXPECT_EQ(points_of(handle), (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(points_of(data["loops"][1]["feature"]), (std::vector<int>{0, 3, 6, 7}));
  EXPECT_FALSE(data_in(page_of(torus_run()))["loops"][0].contains("feature"));
}

TEST(Page, TakesTheVolumeInBlocksWhereItIsLarge) {
  LoopsRun run = torus_run();
  run.volume.values = std::vector<float>(1000, 2.0F);
  std::ostringstream out;
  write_page(out, run, {.most_triangles = 100, .most_voxels = 100});
  const auto data = data_in(out.str());
  EXPECT_EQ(data["volume"]["dims"], (std::vector<int>{4, 4, 4}));
  EXPECT_EQ(data["volume"]["block"], 3);
}

/// Two octahedra and the torus: one of the two is larger than all.
LoopsRun run_of_three_pieces() {
  LoopsRun run = torus_run();
  Surface& surface = run.analysis.surface;
  for (const auto& [radius, x] : {std::pair{1.0F, 20.0F}, std::pair{9.0F, 40.0F}}) {
    const auto first = static_cast<std::uint32_t>(surface.points.size());
    for (std::size_t a = 0; a < 3; ++a)
      for (const float way : {-radius, radius}) {
        std::array<float, 3> point{x, 5.0F, 5.0F};
        point[a] += way;
        surface.points.push_back(point);
        surface.component_of_vertex.push_back(
            static_cast<std::uint32_t>(surface.components.size()));
      }
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
      const std::uint32_t a = first + corner % 2;
      const std::uint32_t b = first + 2 + corner / 2 % 2;
      const std::uint32_t c = first + 4 + corner / 4;
      const bool is_turned = (corner % 2 + corner / 2 % 2 + corner / 4) % 2 == 0;
      surface.triangles.push_back({a, is_turned ? c : b, is_turned ? b : c});
    }
    surface.components.push_back({.vertices = 6, .triangles = 8, .euler = 2});
  }
  return run;
}

TEST(Page, LeavesOutTheSmallestPiecesAndSaysSo) {
  const LoopsRun run = run_of_three_pieces();
  const auto whole = data_in(page_of(run));
  EXPECT_EQ(whole["left_out"]["pieces"], 0);
  ASSERT_EQ(whole["mesh"]["pieces"].size(), 3U);
  EXPECT_EQ(whole["mesh"]["pieces"][0][0], 2) << "the largest area first";
  EXPECT_EQ(whole["mesh"]["pieces"][0][1], 8) << "triangles";
  EXPECT_NEAR(whole["mesh"]["pieces"][0][2].get<double>(), 4 * std::sqrt(3.0) * 4.5 * 4.5, 1e-3);
  EXPECT_EQ(whole["mesh"]["pieces"][2][0], 1);
  std::ostringstream out;
  const LeftOut left_out = write_page(out, run, {.most_pieces = 2});
  EXPECT_EQ(left_out.pieces, 1U);
  EXPECT_EQ(left_out_text(left_out), ", which leaves out 1 small piece");
  const auto data = data_in(out.str());
  EXPECT_EQ(data["left_out"]["pieces"], 1);
  EXPECT_NEAR(data["left_out"]["piece_area"].get<double>(), std::sqrt(3.0), 1e-3);
  EXPECT_EQ(data["mesh"]["pieces"].size(), 2U);
  EXPECT_EQ(data["mesh"]["triangles"], 26);
}

TEST(Page, ShowsAPieceForEveryTwentyTrianglesAtMost) {
  std::ostringstream out;
  const LeftOut left_out = write_page(out, run_of_three_pieces(), {.most_triangles = 40});
  EXPECT_EQ(left_out.pieces, 1U);
  for (const auto& piece : data_in(out.str())["mesh"]["pieces"]) EXPECT_GE(piece[1], 4);
}

TEST(Page, LeavesOutTheSmallestLoopsWhereTheyTakeTooMuchAndSaysSo) {
  LoopsRun run = torus_run();
  run.reported.resize(1, run.reported[0]);
  for (std::int64_t id = 2; id <= 5; ++id) {
    Loop loop = run.reported[0];
    loop.id = id;
    loop.size = static_cast<double>(10 - id);
    run.reported.push_back(loop);
  }
  const std::size_t bytes = data_in(page_of(run))["loops"][0].dump().size();
  std::ostringstream out;
  const LeftOut left_out = write_page(out, run, {.most_loop_bytes = 3 * bytes + 20});
  EXPECT_EQ(left_out.loops, 2U);
  EXPECT_EQ(left_out_text(left_out), ", which leaves out 2 small loops");
  const auto data = data_in(out.str());
  ASSERT_EQ(data["loops"].size(), 3U);
  EXPECT_EQ(data["loops"][0]["id"], 2) << "the size of 8 is the largest; in their order";
  EXPECT_EQ(data["loops"][2]["id"], 4);
  EXPECT_EQ(data["left_out"]["loops"], 2);
  EXPECT_EQ(data["left_out"]["loop_size"], 5.0);
}

TEST(Page, NeedsNoNetwork) {
  const std::string page = page_of(torus_run());
  for (const char* text : {"<link", "src=", "@import", "{{"})
    EXPECT_EQ(page.substr(0, page.find("id=\"data\"")).find(text), std::string::npos) << text;
  EXPECT_GT(page.size(), 400'000U) << "three.js is in it";
}

TEST(Page, NamesOfFilesDoNotEndItsScripts) {
  LoopsRun run = torus_run();
  run.file = "a</script><b>&.raw";
  const std::string page = page_of(run);
  EXPECT_EQ(data_in(page)["file"], run.file);
  EXPECT_NE(page.find("<title>a&lt;/script>&lt;b>&amp;.raw, f <= 0.25"), std::string::npos)
      << page.substr(0, 400);
}

TEST(Page, OfNoSurfaceHoldsNothingButTheVolume) {
  const auto data = data_in(page_of(empty_run()));
  EXPECT_EQ(data["mesh"]["triangles"], 0);
  EXPECT_TRUE(data["loops"].empty());
  EXPECT_EQ(data["box"]["upper"][0], 104.5);
}

TEST(Page, ShowsTheScanIfThereIsOne) {
  LoopsRun run = torus_run();
  EXPECT_EQ(page_of(run).find("<details id=\"scan\">"), std::string::npos);
  run.scan.emplace();
  run.scan->rows = {{0.0, {1, 2, 0}, -2, 2, 10}, {1.0, {1, 2, 0}, -2, 2, 9}};
  run.scan->plateaus = {{.first = 0, .last = 1, .width = 1.0}};
  EXPECT_NE(page_of(run).find("<details id=\"scan\">"), std::string::npos);
}

}  // namespace
}  // namespace isoloop
