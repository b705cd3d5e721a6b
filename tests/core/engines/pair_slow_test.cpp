// Ten thousand volumes: minutes, so not among the tests that run by default.
#include <atomic>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "tests/oracles/pair_comparison.h"

namespace isoloop {
namespace {

TEST(PairSlow, FindsTheKillingPiecesOfTheDualPassOnTenThousandVolumes) {
  std::atomic<std::size_t> compared = 0;
  tbb::parallel_for(0, 10'000, [&](int n) {
    const auto i = static_cast<std::uint32_t>(n);
    const Index3 dims{2 + i % 15, 2 + i / 15 % 15, 2 + i / 225 % 15};
    const testing::Prepared prepared(
        i % 2 == 0 ? testing::white_noise(dims, i)
                   : testing::smooth_noise(dims, i, 1 + static_cast<int>(i / 2 % 3)));
    EXPECT_EQ(testing::difference_of_engines(prepared, compared), "") << "volume " << i;
  });
  EXPECT_GE(compared, 400'000U);
}

}  // namespace
}  // namespace isoloop
