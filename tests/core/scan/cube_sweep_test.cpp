#include "core/scan/cube_sweep.h"

#include <array>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/oracles/cut_of_levels.h"

namespace isoloop {
namespace {

constexpr Step step_count = 40;

/// Corner values of a cube whose levels at a step are the values less the step.
struct Falling {
  CornerLevels values{};

  CornerLevels at(Step step) const {
    CornerLevels levels = values;
    for (double& level : levels) level -= step;
    return levels;
  }
};

/// Ranks by looking at every step.
CubeRanks ranks_of(const Falling& cube) {
  CubeRanks ranks;
  for (Step step = 0; step < step_count; ++step) {
    const CornerLevels levels = cube.at(step);
    for (std::size_t c = 0; c < 8; ++c)
      if (levels[c] >= 0) ranks.corner[c] = static_cast<Step>(step + 1);
    const unsigned joined_faces = testing::cut_of(levels).joined;
    for (std::size_t f = 0; f < 6; ++f) {
      if ((joined_faces >> f & 1U) == 0) continue;
      Steps& joined = ranks.face_joined[f];
      if (joined.empty()) joined.first = step;
      joined.last = static_cast<Step>(step + 1);
    }
  }
  return ranks;
}

TEST(CubeSweep, CountsTheDiscsOfEveryStep) {
  std::mt19937 random(1);
  int tunnels = 0;
  for (int round = 0; round < 20'000; ++round) {
    Falling cube;
    for (double& value : cube.values) value = static_cast<double>(random() % (8 * step_count)) / 8;
    std::array<int, step_count> discs{};
    std::array<int, step_count> joined_by_tunnel{};
    const auto levels_at = [&](Step step) { return cube.at(step); };
    sweep_cube(
        ranks_of(cube), &levels_at,
        [&](Steps steps, int count) {
          for (Step step = steps.first; step < steps.last; ++step) discs[step] += count;
        },
        [&](Step step, const TunnelEnds& ends) {
          ++joined_by_tunnel[step];
          const unsigned inside = testing::cut_of(cube.at(step)).inside;
          EXPECT_EQ(inside >> ends.hub & 1U, inside >> ends.partner & 1U);
          EXPECT_EQ(inside >> ends.hub & 1U, ends.side == Side::inside ? 1U : 0U);
        });
    for (Step step = 0; step < step_count; ++step) {
      const testing::LevelCut cut = testing::cut_of(cube.at(step));
      tunnels += cut.hub ? 1 : 0;
      ASSERT_EQ(discs[step], cut.cut->disc_count);
      ASSERT_EQ(joined_by_tunnel[step], cut.hub ? 1 : 0);
    }
  }
  EXPECT_GT(tunnels, 100);
}

TEST(CubeSweep, ATunnelJoinsTwoCellsOfItsSide) {
  // Two corners of a diagonal inside: case 4.
  const std::uint8_t inside = 0b1000'0001;
  const TunnelEnds ends = tunnel_ends(inside, 0, cube_cut(inside, 0, false).hubs[0]);
  EXPECT_EQ(ends.side, Side::inside);
  EXPECT_EQ(ends.hub + ends.partner, 7);
}

}  // namespace
}  // namespace isoloop
