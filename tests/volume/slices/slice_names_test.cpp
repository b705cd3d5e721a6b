#include "volume/slices/slice_names.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

using test::contains;
using Names = std::vector<std::string>;

TEST(SliceNames, NumbersCompareByTheirValue) {
  const Names ordered{"1.tif", "2.tif", "10.tif", "a1b2", "a1b10", "a02b1", "b", "b0"};
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    for (std::size_t j = 0; j < ordered.size(); ++j) {
      EXPECT_EQ(name_less(ordered[i], ordered[j]), i < j) << ordered[i] << ' ' << ordered[j];
    }
  }
}

TEST(SliceNames, EvenNumbersAreNotWarnedOf) {
  for (const Names& names :
       {Names{"a.tif"}, Names{"a.tif", "b.tif"}, Names{"1.tif", "2.tif"},
        Names{"z0010.tif", "z0020.tif", "z0030.tif"}, Names{"s7_1.png", "s7_2.png", "s7_3.png"},
        Names{"t0930_1.png", "t0931_2.png", "t0933_3.png"}}) {
    EXPECT_FALSE(odd_names(names, "f")) << names.back();
  }
}

TEST(SliceNames, AGapIsWarnedOf) {
  const auto one = odd_names({"1.tif", "2.tif", "3.tif", "5.tif"}, "f");
  ASSERT_TRUE(one);
  EXPECT_TRUE(contains(*one, "1 gap") && contains(*one, "after 3 comes 5")) << *one;
  const auto two = odd_names({"t1_1.tif", "t1_2.tif", "t2_4.tif", "t2_5.tif", "t3_7.tif"}, "f");
  EXPECT_TRUE(two && contains(*two, "2 gaps"));
}

TEST(SliceNames, NamesOfSeveralSortsAreWarnedOf) {
  const auto odd = odd_names({"Image.tif", "Image2.tif", "Image3.tif"}, "f");
  ASSERT_TRUE(odd);
  EXPECT_TRUE(contains(*odd, "Image.tif, Image2.tif")) << *odd;
}

TEST(SliceNames, TwoAxesAndTwiceOneNumberAreRefused) {
  for (const Names& names : {Names{"z1_c1", "z1_c2", "z2_c1", "z2_c2", "z3_c1", "z3_c2"},
                             Names{"01.tif", "1.tif"}, Names{"a1", "a01", "a2"}}) {
    EXPECT_THROW(odd_names(names, "f"), InvalidInput) << names.front();
  }
}

}  // namespace
}  // namespace isoloop
