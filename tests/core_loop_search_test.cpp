#include <algorithm>
#include <limits>
#include <span>

#include <gtest/gtest.h>

#include "core/killing_border.h"
#include "core/loop_search.h"
#include "tests/core_fixture.h"

namespace isoloop {
namespace {

constexpr double any_length = std::numeric_limits<double>::infinity();

struct Torus {
  Torus()
      : prepared(testing::torus({24, 24, 24}), GeodesicMode::hierarchy),
        inside(dual_pass(*prepared.inside)),
        outside(dual_pass(*prepared.outside)),
        classes(surface_classes(prepared.surface, *prepared.inside, inside, *prepared.outside,
                                outside)) {}
  testing::Prepared prepared;
  DualPass inside;
  DualPass outside;
  SurfaceClasses classes;
};

bool is_handle(std::span<const std::uint32_t> set) { return set.size() == 1 && set[0] == 1; }

TEST(LoopSearch, FindsALoopOfTheWantedClassFromEveryVertex) {
  const Torus torus;
  LoopSearch search(torus.prepared.surface, torus.classes);
  double shortest = any_length;
  double longest = 0.0;
  for (std::uint32_t base = 0; base < torus.prepared.surface.points.size(); base += 13) {
    const auto found = search.run(base, any_length, is_handle);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(class_of(torus.prepared.surface, torus.classes, {&found->curve, 1}),
              (GeneratorSet{1}));
    EXPECT_NEAR(found->length, length_of(torus.prepared.surface, {&found->curve, 1}), 1e-3);
    shortest = std::min(shortest, found->length);
    longest = std::max(longest, found->length);
  }
  EXPECT_LT(longest, 1.3 * shortest) << "the tube is equally thick everywhere";
}

TEST(LoopSearch, ReturnsNothingLongerThanAllowed) {
  const Torus torus;
  LoopSearch search(torus.prepared.surface, torus.classes);
  const double length = search.run(0, any_length, is_handle)->length;
  EXPECT_FALSE(search.run(0, 0.9 * length, is_handle).has_value());
}

TEST(LoopSearch, ReturnsNothingWhereNoClassIsWanted) {
  const Torus torus;
  LoopSearch search(torus.prepared.surface, torus.classes);
  EXPECT_FALSE(search.run(0, any_length, [](auto) { return false; }).has_value());
}

}  // namespace
}  // namespace isoloop
