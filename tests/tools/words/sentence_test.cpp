#include "tools/words/sentence.h"

#include <gtest/gtest.h>

namespace isoloop {
namespace {

TEST(Sentence, SaysWhereWhatAndWhatToDo) {
  EXPECT_EQ(sentence_of({.file = "a.npy",
                         .place = "voxel (1, 0, 2)",
                         .text = "NaN",
                         .advice = {Advice::replace_nan}}),
            "a.npy: voxel (1, 0, 2): NaN; say with --nan-as VALUE what NaN stands for");
}

TEST(Sentence, AnOptionThatItIsAboutIsTheFlag) {
  const Finding finding{.file = "a.raw", .about = Option::crop, .text = "asks for nothing"};
  EXPECT_EQ(sentence_of(finding), "a.raw: --crop asks for nothing");
  EXPECT_EQ(text_of(finding), "a.raw: the crop asks for nothing");
}

TEST(Sentence, TheFlagOfAnArgumentIsNamedOnce) {
  EXPECT_EQ(sentence_of({.text = "no voxel has the label 7"}, "count", Option::labels),
            "no voxel has the label 7 (--label)");
  EXPECT_EQ(sentence_of({.text = "holds 3 frames", .advice = {Advice::choose_frame}}, "count",
                        Option::frame),
            "holds 3 frames; choose with --frame N");
  EXPECT_EQ(sentence_of({.about = Option::frame, .text = "counts from 0"}, "", Option::frame),
            "--frame counts from 0");
}

TEST(Sentence, WaysThatReadAlikeAreSaidOnce) {
  const std::vector<Advice> ways{Advice::take_part, Advice::take_smaller_volume};
  EXPECT_EQ(advice_text(ways, "generate"), "take a smaller --size");
  EXPECT_EQ(advice_text(ways), "read a part of the volume (--crop) or take a smaller volume");
}

TEST(Sentence, EveryAdviceAndEveryOptionHasWords) {
  for (int a = 0; a <= static_cast<int>(last_advice); ++a)
    EXPECT_FALSE(advice_text({static_cast<Advice>(a)}).empty()) << a;
  for (int o = 1; o <= static_cast<int>(last_option); ++o) {
    const auto option = static_cast<Option>(o);
    EXPECT_FALSE(name_of(option).empty()) << o;
    EXPECT_TRUE(option == Option::shape || flag_of(option).starts_with("--")) << o;
  }
}

TEST(Sentence, IsOneLineWithoutFullStop) {
  EXPECT_EQ(sentence_of({.text = "one\ntwo.\n"}), "one two");
}

}  // namespace
}  // namespace isoloop
