#include "tools/flags/flag_lists.h"

#include <gtest/gtest.h>

namespace isoloop {
namespace {

TEST(ParseLabels, TakesWholeNumbersAndCommas) {
  EXPECT_EQ(parse_labels("3"), (std::vector<std::int64_t>{3}));
  EXPECT_EQ(parse_labels("3,-7, 12"), (std::vector<std::int64_t>{3, -7, 12}));
  EXPECT_EQ(parse_labels("3 7"), (std::vector<std::int64_t>{3, 7}));
}

TEST(ParseLabels, RefusesWhatIsNoLabelAndCommasWithoutOne) {
  for (const char* text :
       {"", "3,", "3,,4", ",3", "3.5", "3x4", "a", "3, ", ",", "99999999999999999999"}) {
    EXPECT_THROW(parse_labels(text), InvalidArgument) << text;
  }
}

TEST(ParseCrop, TakesRangesThatMayBeOpenAtEitherEnd) {
  const CropBox box = parse_crop("10:20,:5, 3: ");
  EXPECT_EQ(box[0].begin, 10);
  EXPECT_EQ(box[0].end, 20);
  EXPECT_FALSE(box[1].begin);
  EXPECT_EQ(box[1].end, 5);
  EXPECT_EQ(box[2].begin, 3);
  EXPECT_FALSE(box[2].end);
  for (const char* all : {":,:,:", ",,", " , : ,"}) {
    for (const CropRange& range : parse_crop(all)) EXPECT_FALSE(range.begin || range.end) << all;
  }
  EXPECT_EQ(parse_crop("-3:4,:,:")[0].begin, -3);  // refused where the dims are known
}

TEST(ParseCrop, RefusesWhatIsNotThreeRanges) {
  for (const char* text : {"", ":", "1:2,3:4", "1:2,3:4,5:6,7:8", "5,:,:", "1:2:3,:,:", "a:b,:,:",
                           "1:2,:,:,", "1.5:2,:,:", "1:99999999999999999999,:,:"}) {
    EXPECT_THROW(parse_crop(text), InvalidArgument) << text;
  }
}

}  // namespace
}  // namespace isoloop
