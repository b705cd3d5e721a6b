#include "volume/voxels/length_unit.h"

#include <gtest/gtest.h>

namespace isoloop {
namespace {

TEST(LengthUnit, EverySpellingOfAMicrometreIsOne) {
  for (const char* spelling :
       {"um", "µm", "\xce\xbcm", "\\u00B5m", "\xb5m", "micron", " Microns "}) {
    const auto unit = length_unit(spelling);
    ASSERT_TRUE(unit) << spelling;
    EXPECT_EQ(unit->name, "µm");
    EXPECT_DOUBLE_EQ(unit->metres, 1e-6);
  }
}

TEST(LengthUnit, WhatIsNoLengthIsNone) {
  for (const char* spelling : {"", "pixel", "pixels", "reference frame", "mmm", "s"}) {
    EXPECT_FALSE(length_unit(spelling)) << spelling;
  }
}

}  // namespace
}  // namespace isoloop
