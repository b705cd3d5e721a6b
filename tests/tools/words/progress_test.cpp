#include "tools/words/progress.h"

#include <limits>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace isoloop {
namespace {

constexpr std::chrono::milliseconds at_once{0};

TEST(ProgressLine, ShowsStageAndShare) {
  std::ostringstream out;
  ProgressLine line(out, {.quiet = at_once, .between_lines = at_once});
  line.show("sizes", 0.5);
  EXPECT_EQ(out.str(), "\risoloop: sizes 50 %");
}

TEST(ProgressLine, CoversALongerLineWithBlanks) {
  std::ostringstream out;
  ProgressLine line(out, {.quiet = at_once, .between_lines = at_once});
  line.show("surface", 1.0);
  out.str("");
  line.show("pass", 1.0);
  EXPECT_EQ(out.str(), "\risoloop: pass 100 %   ");
}

TEST(ProgressLine, IsGoneAtTheEnd) {
  std::ostringstream out;
  {
    ProgressLine line(out, {.quiet = at_once, .between_lines = at_once});
    line.show("pass", 0.0);
    out.str("");
  }
  EXPECT_EQ(out.str(), "\r" + std::string(17, ' ') + "\r");
}

TEST(ProgressLine, IsSilentInAShortRun) {
  std::ostringstream out;
  {
    ProgressLine line(out, {.quiet = std::chrono::hours(1)});
    line.show("pass", 0.5);
  }
  EXPECT_EQ(out.str(), "");
}

TEST(ProgressLine, ShowsAStageThatBeganInTheQuietTime) {
  std::ostringstream out;
  {
    ProgressLine line(out, {.quiet = std::chrono::milliseconds(20)});
    line.show("pass", 0.25);
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
  EXPECT_TRUE(out.str().starts_with("\risoloop: pass 25 %")) << out.str();
}

TEST(ProgressLine, IsSilentWhenDisabled) {
  std::ostringstream out;
  ProgressLine line(out, {.enabled = false, .quiet = at_once});
  line.show("pass", 0.5);
  EXPECT_FALSE(line.callback());
  EXPECT_EQ(out.str(), "");
}

TEST(ProgressLine, KeepsSharesBetweenZeroAndOne) {
  std::ostringstream out;
  ProgressLine line(out, {.quiet = at_once, .between_lines = at_once});
  const Progress progress = line.callback();
  progress("a", -1.0);
  progress("b", 7.0);
  progress("c", std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(out.str(), "\risoloop: a 0 %\risoloop: b 100 %\risoloop: c 0 %  ");
}

TEST(ProgressLine, SaysHowMuchTimeIsLeft) {
  std::ostringstream out;
  ProgressLine line(out, {.quiet = at_once, .between_lines = at_once});
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  line.show("pass", 0.1);
  EXPECT_NE(out.str().find("pass 10 %, about "), std::string::npos) << out.str();
  EXPECT_NE(out.str().find(" s left"), std::string::npos) << out.str();
  out.str("");
  line.show("pass", 1.0);
  EXPECT_EQ(out.str().find("left"), std::string::npos) << out.str();
}

TEST(ProgressLine, TimeLeftIsInSecondsMinutesOrHours) {
  EXPECT_EQ(time_left_text(std::chrono::seconds(-3)), "0 s");
  EXPECT_EQ(time_left_text(std::chrono::seconds(89)), "89 s");
  EXPECT_EQ(time_left_text(std::chrono::seconds(130)), "2 min");
  EXPECT_EQ(time_left_text(std::chrono::minutes(100)), "1.7 h");
}

TEST(ProgressLine, AsJsonIsAnObjectALine) {
  std::ostringstream out;
  {
    ProgressLine line(out, {.form = ProgressForm::json});
    line.show("surface", 0.0);
    line.show("pass", 0.5);
  }
  std::istringstream lines(out.str());
  std::string text;
  std::vector<nlohmann::json> events;
  while (std::getline(lines, text)) events.push_back(nlohmann::json::parse(text));
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1]["event"], "progress");
  EXPECT_EQ(events[1]["stage"], "pass");
  EXPECT_EQ(events[1]["share"], 0.5);
  EXPECT_GE(events[1]["seconds"], 0.0);
}

TEST(ProgressLine, DoesNotFloodTheTerminal) {
  std::ostringstream out;
  ProgressLine line(out, {.quiet = at_once, .between_lines = std::chrono::hours(1)});
  for (int i = 0; i < 100; ++i) line.show("pass", i / 100.0);
  EXPECT_EQ(out.str(), "\risoloop: pass 0 %");
}

}  // namespace
}  // namespace isoloop
