#include "tools/words/value_hints.h"

#include <gtest/gtest.h>

#include "tests/samples/contains.h"

namespace isoloop {
namespace {

using test::contains;

ValueRange range_of(const std::vector<double>& values) {
  return {values.front(), values.back(), values};
}

TEST(ValueHints, TwoValuesAreAMask) {
  EXPECT_TRUE(is_mask(range_of({0, 255})));
  EXPECT_FALSE(is_mask(range_of({0, 1, 255})));
  EXPECT_FALSE(is_mask(range_of({7})));
  EXPECT_FALSE(is_mask({0, 255, {}}));
  const std::string hint = mask_hint(range_of({0, 255}));
  EXPECT_TRUE(contains(hint, "0 and 255")) << hint;
  EXPECT_TRUE(contains(hint, "--label 255 --connectivity 26")) << hint;
  EXPECT_TRUE(contains(values_text(range_of({0, 255})), "--label 255")) << hint;
}

TEST(ValueHints, AnInsideThatIsNoLabelIsNamedByItsIsoValue) {
  EXPECT_TRUE(contains(mask_hint(range_of({0, 0.5})), "--iso 0.5 --connectivity 26"));
}

TEST(ValueHints, AFewWholeNumbersNearEachOtherAreALabelMap) {
  EXPECT_TRUE(is_label_map(range_of({0, 1, 2, 5})));
  EXPECT_FALSE(is_label_map(range_of({0, 1})));
  EXPECT_FALSE(is_label_map(range_of({0, 1, 2.5})));
  EXPECT_FALSE(is_label_map(range_of({0, 100, 2000})));
  EXPECT_FALSE(is_label_map({0, 200, {}}));
  const std::string text = values_text(range_of({0, 1, 2, 5}));
  EXPECT_TRUE(contains(text, "0, 1, 2, 5") && contains(text, "--label N")) << text;
  EXPECT_EQ(values_text({-3, 4, {}}), "its values run from -3 to 4");
}

}  // namespace
}  // namespace isoloop
