#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "tests/oracles/random_volumes.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using testing::zero_level;

std::vector<double> short_lengths(const Analysis& analysis, LoopKind kind, double limit) {
  std::vector<double> lengths;
  for (const Loop& loop : analysis.loops)
    if (loop.kind == kind && loop.length < limit) lengths.push_back(loop.length);
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

double total_length(const Analysis& analysis) {
  double sum = 0.0;
  for (const Loop& loop : analysis.loops) sum += loop.length;
  return sum;
}

void expect_lengths(const std::vector<double>& lengths, const std::vector<double>& expected,
                    std::uint32_t seed) {
  ASSERT_EQ(lengths.size(), expected.size()) << "seed " << seed;
  for (std::size_t i = 0; i < lengths.size(); ++i)
    EXPECT_NEAR(lengths[i], expected[i], 1e-9 * expected[i]) << "seed " << seed;
}

TEST(ShortenBelow, LeavesTheShortLoopsAsShortAsTheyAreWithoutALimit) {
  constexpr double limit = 12.0;
  bool leaves_some_longer = false;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const auto volume = testing::noise_of_some_size(seed);
    const Analysis whole = analyze(volume.view(), zero_level);
    AnalysisOptions options;
    options.shorten_below = {.handles = limit, .tunnels = limit};
    const Analysis limited = analyze(volume.view(), zero_level, options);
    ASSERT_EQ(limited.loops.size(), whole.loops.size());
    for (const LoopKind kind : {LoopKind::handle, LoopKind::tunnel})
      expect_lengths(short_lengths(limited, kind, limit), short_lengths(whole, kind, limit), seed);
    leaves_some_longer = leaves_some_longer || total_length(limited) > total_length(whole);
  }
  EXPECT_TRUE(leaves_some_longer);
}

TEST(ShortenBelow, OneKindsShortLoopsDoNotAskForTheOthers) {
  constexpr double limit = 12.0;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const auto volume = testing::noise_of_some_size(seed);
    const Analysis whole = analyze(volume.view(), zero_level);
    AnalysisOptions options;
    options.shorten_below = {.handles = 0.0, .tunnels = limit};
    const Analysis limited = analyze(volume.view(), zero_level, options);
    expect_lengths(short_lengths(limited, LoopKind::tunnel, limit),
                   short_lengths(whole, LoopKind::tunnel, limit), seed);
  }
}

}  // namespace
}  // namespace isoloop
