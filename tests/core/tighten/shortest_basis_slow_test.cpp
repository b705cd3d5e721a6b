// Five hundred surfaces against the exact minimum: half a minute, so not among the default tests.
#include <cstdio>
#include <mutex>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "tests/oracles/basis_comparison.h"

namespace isoloop {
namespace {

TEST(ShortestBasisSlow, IsNextToTheLeastOnFiveHundredSurfaces) {
  std::vector<std::uint32_t> seeds;
  for (std::uint32_t seed = 0; seeds.size() < 500; ++seed)
    if (testing::small_surface(seed)) seeds.push_back(seed);
  testing::Tally tally;
  std::mutex mutex;
  tbb::parallel_for(std::size_t{0}, seeds.size(), [&](std::size_t n) {
    const double ratio = testing::shortened_over_least(*testing::small_surface(seeds[n]));
    const std::lock_guard lock(mutex);
    tally.add(ratio);
  });
  std::printf("mean %.6f, worst %.6f, equal %d of %d\n", tally.sum / tally.surfaces, tally.worst,
              tally.equal, tally.surfaces);
  EXPECT_LE(tally.sum / tally.surfaces, 1.02);
  EXPECT_LE(tally.worst, 1.10);
  EXPECT_GE(tally.equal, 0.8 * tally.surfaces);
}

}  // namespace
}  // namespace isoloop
