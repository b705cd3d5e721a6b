// Five thousand volumes: minutes, so not among the tests that run by default.
#include <atomic>
#include <cstdint>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "tests/oracles/octree_comparison.h"

namespace isoloop {
namespace {

TEST(OctreeComplexSlow, PairAndThePassFindTheSameKillingPiecesOnFiveThousandVolumes) {
  std::atomic<std::size_t> compared = 0;
  tbb::parallel_for(std::uint32_t{0}, std::uint32_t{5000}, [&](std::uint32_t seed) {
    EXPECT_EQ(testing::difference_on_octree(seed, compared), "") << "volume " << seed;
  });
  EXPECT_GT(compared, 25'000U);
}

}  // namespace
}  // namespace isoloop
