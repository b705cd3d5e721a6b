#include "core/curves/triangle_fans.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

TEST(TriangleFans, KnowTheThirdCornerBesideEveryDirectedEdge) {
  const testing::Prepared prepared(testing::torus({20, 20, 20}));
  const TriangleFans fans(prepared.surface);
  for (const auto& [a, b, c] : prepared.surface.triangles) {
    ASSERT_EQ(fans.apex(a, b), c);
    ASSERT_EQ(fans.apex(b, c), a);
    ASSERT_EQ(fans.apex(c, a), b);
  }
}

TEST(TriangleFans, HaveNoneBesideWhatIsNoEdge) {
  const testing::Prepared prepared(testing::torus({20, 20, 20}));
  const TriangleFans fans(prepared.surface);
  EXPECT_THROW(fans.apex(0, 0), SelfCheckFailed);
}

}  // namespace
}  // namespace isoloop
