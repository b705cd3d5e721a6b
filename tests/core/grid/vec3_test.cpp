#include "core/grid/vec3.h"

#include <gtest/gtest.h>

namespace isoloop {
namespace {

TEST(Vec3, CrossIsRightHandedAndAtRightAnglesToBoth) {
  EXPECT_EQ(cross({1, 0, 0}, {0, 1, 0}), (Vec3{0, 0, 1}));
  const Vec3 a{1, 2, 3};
  const Vec3 b{-4, 5, 6};
  EXPECT_EQ(dot(cross(a, b), a), 0.0);
  EXPECT_EQ(dot(cross(a, b), b), 0.0);
}

TEST(Vec3, MinusUndoesPlus) {
  const Vec3 a{1, 2, 3};
  const Vec3 b{-4, 5, 6};
  EXPECT_EQ(plus(a, b), (Vec3{-3, 7, 9}));
  EXPECT_EQ(minus(plus(a, b), b), a);
}

TEST(Vec3, TheNormIsFiniteWhereSquaresAreNot) { EXPECT_DOUBLE_EQ(norm({3e200, 0, 4e200}), 5e200); }

}  // namespace
}  // namespace isoloop
