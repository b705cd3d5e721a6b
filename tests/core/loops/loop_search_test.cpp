#include "core/loops/loop_search.h"

#include <algorithm>
#include <limits>
#include <map>
#include <span>

#include <gtest/gtest.h>

#include "core/sizes/bounded_search.h"
#include "core/sizes/surface_hierarchy.h"
#include "tests/oracles/exact_basis.h"
#include "tests/samples/classified.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

constexpr double any_length = std::numeric_limits<double>::infinity();

struct Torus : testing::Classified {
  Torus() : testing::Classified(testing::torus({24, 24, 24})) {}
};

/// Generator 0 is that of the inside, 1 that of the outside: a handle loop is {} inside, {0}
/// outside.
WantedLoops any_handle() {
  return {{}, [](std::span<const std::uint32_t>) { return any_length; }};
}

TEST(LoopSearch, FindsALoopOfTheWantedClassFromEveryVertex) {
  const Torus torus;
  LoopSearch search(torus.prepared.surface, torus.classes, Side::inside);
  search.look_for(any_handle());
  double shortest = any_length;
  double longest = 0.0;
  for (std::uint32_t base = 0; base < torus.prepared.surface.points.size(); base += 13) {
    const auto found = search.shortest(base, {any_length});
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(class_of(torus.prepared.surface, torus.classes, found->curves), (GeneratorSet{1}));
    EXPECT_EQ(found->other, (GeneratorSet{0}));
    EXPECT_NEAR(found->length, length_of(torus.prepared.surface, found->curves), 1e-3);
    shortest = std::min(shortest, found->length);
    longest = std::max(longest, found->length);
  }
  EXPECT_LT(longest, 1.3 * shortest) << "the tube is equally thick everywhere";
}

TEST(LoopSearch, FindsLoopsOfAnOwnClassThatDoNotBound) {
  const Torus torus;
  LoopSearch search(torus.prepared.surface, torus.classes, Side::outside);
  search.look_for(
      {{0}, [](std::span<const std::uint32_t> other) { return other.empty() ? any_length : 0.0; }});
  const auto found = search.shortest(5, {any_length});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(class_of(torus.prepared.surface, torus.classes, found->curves), (GeneratorSet{1}));
}

TEST(LoopSearch, ReturnsNothingLongerThanAllowed) {
  const Torus torus;
  LoopSearch search(torus.prepared.surface, torus.classes, Side::inside);
  search.look_for(any_handle());
  const double length = search.shortest(0, {any_length})->length;
  EXPECT_FALSE(search.shortest(0, {0.9 * length}).has_value());
}

TEST(LoopSearch, StaysNearACurveUntilToldOtherwise) {
  const Torus torus;
  LoopSearch search(torus.prepared.surface, torus.classes, Side::inside);
  search.look_for(any_handle());
  const FoundLoop loop = search.shortest(0, {any_length}).value();
  const Curve& curve = loop.curves.front();
  const std::uint32_t opposite = curve[curve.size() / 2];
  search.stay_near({0}, curve.size() / 4);
  EXPECT_FALSE(search.shortest(0, {any_length}).has_value()) << "a disk has no handle loop";
  search.stay_near(curve, 2);
  const auto near = search.shortest(opposite, {any_length});
  ASSERT_TRUE(near.has_value());
  search.stay_near({}, 0);
  const auto anywhere = search.shortest(opposite, {any_length});
  ASSERT_TRUE(anywhere.has_value());
  EXPECT_LE(anywhere->length, near->length);
  EXPECT_LE(near->length, loop.length) << "the curve itself lies in the band";
}

TEST(LoopSearch, TellsHowFarItCame) {
  const Torus torus;
  const Surface& surface = torus.prepared.surface;
  LoopSearch search(surface, torus.classes, Side::inside);
  search.look_for(any_handle());
  constexpr double longest = 12.0;
  search.shortest(0, {longest});
  std::vector<Goal> goals;
  for (std::uint32_t v = 1; v < surface.points.size(); ++v) goals.push_back({v});
  BoundedSearch(surface.graph, finest_tier(surface).centers, longest / 2, 0.5).run(0, goals);
  std::size_t reached = 1;
  for (const Goal& goal : goals) {
    if (goal.length == std::numeric_limits<float>::infinity()) continue;
    EXPECT_NEAR(search.distance_to(goal.vertex), goal.length, 1e-4);
    ++reached;
  }
  std::size_t finite = 0;
  for (std::uint32_t v = 0; v < surface.points.size(); ++v)
    finite += search.distance_to(v) < any_length ? 1 : 0;
  EXPECT_EQ(finite, reached);
  EXPECT_LT(reached, surface.points.size());
}

TEST(LoopSearch, ReturnsNothingWhereNoClassIsWanted) {
  const Torus torus;
  LoopSearch search(torus.prepared.surface, torus.classes, Side::inside);
  search.look_for({{}, [](auto) { return 0.0; }});
  EXPECT_FALSE(search.shortest(0, {any_length}).has_value());
  EXPECT_TRUE(search.shortest_of_each_class(0, {20.0, 4}).loops.empty());
}

TEST(LoopSearch, AllSheetsFindTheShortestClosedWalkOfEachClass) {
  // Against Dijkstra's search on pairs of a vertex and a class, written out with maps.
  const testing::Classified solid(testing::smooth_noise({10, 10, 10}, 4, 1));
  const Surface& surface = solid.prepared.surface;
  LoopSearch search(surface, solid.classes, Side::inside);
  search.look_for(any_handle());
  std::size_t compared = 0;
  for (std::uint32_t base = 0; base < surface.points.size(); base += 17) {
    constexpr double longest = 14.0;
    std::map<GeneratorSet, double> shortest;
    for (const auto& [set, length] : testing::closed_walks(surface, solid.classes, base, longest)) {
      const SplitClass parts = split_class(solid.classes, Side::inside, set);
      if (parts.own.empty() && !parts.other.empty()) shortest[parts.other] = length;
    }
    const SearchResult found = search.shortest_of_each_class(base, {longest, 1000});
    ASSERT_EQ(found.loops.size(), shortest.size()) << base;
    for (const FoundLoop& loop : found.loops) {
      EXPECT_LE(loop.length, shortest.at(loop.other) + 1e-4) << "a stem may be cut off";
      const auto set = class_of(surface, solid.classes, loop.curves);
      EXPECT_EQ(split_class(solid.classes, Side::inside, set).other, loop.other);
      ++compared;
    }
  }
  EXPECT_GT(compared, 50U);
}

TEST(LoopSearch, OneSheetFindsTheShortestClosedWalkThatCrosses) {
  const testing::Classified solid(testing::smooth_noise({10, 10, 10}, 4, 1));
  const Surface& surface = solid.prepared.surface;
  LoopSearch search(surface, solid.classes, Side::inside);
  search.look_for({{}, [](auto) { return 0.0; }});
  const GeneratorSet crossing{0};
  std::size_t met = 0;
  for (std::uint32_t base = 0; base < surface.points.size(); base += 17) {
    constexpr double longest = 14.0;
    double shortest = longest;
    for (const auto& [set, length] : testing::closed_walks(surface, solid.classes, base, longest)) {
      const GeneratorSet other = split_class(solid.classes, Side::inside, set).other;
      if (!other.empty() && other.front() == 0) shortest = std::min(shortest, length);
    }
    const SearchResult found = search.shortest_of_each_class(base, {longest, 1}, crossing);
    EXPECT_NEAR(found.shortest_crossing, shortest, 1e-4) << base;
    met += shortest < longest ? 1 : 0;
  }
  EXPECT_GT(met, 5U);
}

}  // namespace
}  // namespace isoloop
