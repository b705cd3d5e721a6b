#include "core/repair/membrane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "core/analysis/workings.h"
#include "core/repair/loop_remover.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using testing::zero_level;
using Vertices = std::vector<std::uint32_t>;

TEST(Membrane, EitherLeastSetPartsTheHandleOrPlugsTheTunnel) {
  const testing::SmallVolume torus = testing::torus({26, 26, 16});
  const Workings workings = work_out_loops(torus.view(), zero_level);
  const std::vector<bool> none(workings.sides->lattice.vertex_count());
  for (const Loop& loop : workings.analysis.loops) {
    const Side side = side_of(loop.kind);
    MembraneFinder finder(*workings.sides, *workings.on(side).complex, workings.on(side).pass);
    const LoopSite site = site_of(workings, loop);
    const MembraneQuery query{site.crossing, site.edges, none, none};
    std::vector<Vertices> sets;
    const auto has_passed = finder.thin(query, {.reach = 5}, [&](const Vertices& set) {
      sets.push_back(set);
      return false;
    });
    EXPECT_EQ(has_passed, false);
    EXPECT_EQ(sets.size(), 2U);
    for (const Vertices& set : sets) {
      testing::SmallVolume changed = torus;
      for (const std::uint32_t vertex : set) {
        const auto p = workings.sides->lattice.position(vertex);
        const auto& first = workings.sides->lattice.first;
        const Index3 q{first[0] + p[0], first[1] + p[1], first[2] + p[2]};
        changed.values[static_cast<std::size_t>(q[0] + 26 * (q[1] + 26 * q[2]))] =
            side == Side::inside ? -1.0 : 1.0;
      }
      EXPECT_EQ(count_topology(changed.view(), zero_level).surface.genus(), 0);
    }
  }
}

TEST(Membrane, TheFirstSetThatWillDoEndsTheSearch) {
  const testing::SmallVolume torus = testing::torus({26, 26, 16});
  const Workings workings = work_out_loops(torus.view(), zero_level);
  const LoopSite site = site_of(workings, workings.analysis.loops.at(0));
  const WorkedSide& on = workings.on(side_of(site.kind));
  MembraneFinder finder(*workings.sides, *on.complex, on.pass);
  const std::vector<bool> none(workings.sides->lattice.vertex_count());
  int calls = 0;
  const auto use = [&](const Vertices&) { return ++calls > 0; };
  EXPECT_EQ(finder.thin({site.crossing, site.edges, none, none}, {.reach = 5}, use), true);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(finder.thin({site.crossing, {}, none, none}, {.reach = 5}, use), std::nullopt);
  EXPECT_EQ(calls, 1);
}

/// A ball of radius 8, and what asks for nothing in it.
struct Ball {
  testing::Prepared prepared{testing::sampled({20, 20, 20}, [](double x, double y, double z) {
    return 8.0 - std::hypot(x - 9.5, y - 9.5, z - 9.5);
  })};
  DualPass pass = prepared.pass_on(Side::inside);
  MembraneFinder<GridComplex> finder{prepared.sides, *prepared.inside, pass};
  std::vector<bool> fixed = std::vector<bool>(prepared.sides.lattice.vertex_count());
  std::vector<bool> gone = fixed;

  template <class Choose>
  Vertices inside_where(const Choose& choose) const {
    Vertices vertices;
    const Lattice& lattice = prepared.sides.lattice;
    for (std::uint32_t v = 0; v < lattice.vertex_count(); ++v) {
      const auto p = lattice.position(v);
      std::array<double, 3> q{};
      for (std::size_t a = 0; a < 3; ++a) q[a] = static_cast<double>(lattice.first[a] + p[a]);
      if (prepared.sides.is_on(Side::inside, v) && choose(q)) vertices.push_back(v);
    }
    return vertices;
  }

  /// On the cubes of side 2 distance about voxel (9, 9, 9).
  Vertices cube_shell(double distance) const {
    return inside_where([&](const auto& q) { return from_middle(q) == distance; });
  }
  Vertices cube(double distance) const {
    return inside_where([&](const auto& q) { return from_middle(q) <= distance; });
  }

  Vertices with_severed(const Vertices& set, std::size_t most) {
    return finder.with_severed({{}, {}, fixed, gone}, set, most);
  }

 private:
  static double from_middle(const std::array<double, 3>& q) {
    return std::max({std::abs(q[0] - 9.0), std::abs(q[1] - 9.0), std::abs(q[2] - 9.0)});
  }
};

TEST(Membrane, TakesAlongWhatASetSevers) {
  Ball ball;
  EXPECT_EQ(ball.with_severed(ball.cube_shell(2.0), 27), ball.cube(2.0));
}

TEST(Membrane, LeavesPartsThatAreTooLargeAndThoseThatAreFixed) {
  Ball ball;
  const Vertices shell = ball.cube_shell(2.0);
  EXPECT_EQ(ball.with_severed(shell, 26), shell);
  ball.fixed[ball.cube(0.0).at(0)] = true;
  EXPECT_EQ(ball.with_severed(shell, 27), shell);
}

TEST(Membrane, OfTwoPartsTheLargerStays) {
  Ball ball;
  const Vertices plane = ball.inside_where([](const auto& q) { return q[0] == 13.0; });
  const Vertices cap = ball.inside_where([](const auto& q) { return q[0] >= 13.0; });
  EXPECT_EQ(ball.with_severed(plane, 1'000'000), cap);
}

TEST(Membrane, ASetThatSeversNothingStaysAsItIs) {
  Ball ball;
  const Vertices cube = ball.cube(2.0);
  EXPECT_EQ(ball.with_severed(cube, 1000), cube);
}

}  // namespace
}  // namespace isoloop
