#include "volume/base/memory_limit.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

TEST(MemoryLimit, CountsVoxelsAndBytes) {
  EXPECT_EQ(checked_voxel_count({256, 256, 128}, "f"), 8388608U);
  EXPECT_EQ(checked_voxel_bytes({256, 256, 128}, 8, "f"), 67108864U);
}

TEST(MemoryLimit, RefusesProductsThatOverflow) {
  const std::int64_t big = std::int64_t{1} << 32;
  EXPECT_THROW(checked_voxel_count({big, big, 1}, "f"), LimitExceeded);
  EXPECT_THROW(checked_voxel_count({big, big, big}, "f"), LimitExceeded);
  EXPECT_THROW(checked_voxel_bytes({big, big / 4, 1}, 8, "f"), LimitExceeded);
  EXPECT_EQ(checked_voxel_count({big, big / 4, 1}, "f"), std::uint64_t{1} << 62);
}

TEST(MemoryLimit, RefusesDimensionsBelowOne) {
  EXPECT_THROW(checked_voxel_count({0, 4, 4}, "f"), InvalidArgument);
  EXPECT_THROW(checked_voxel_count({4, 4, -4}, "f"), InvalidArgument);
  EXPECT_THROW(checked_voxel_count({-4, -4, 4}, "f"), InvalidArgument);
}

TEST(MemoryLimit, AllowsTheLimitItselfAndNotAByteMore) {
  EXPECT_NO_THROW(check_voxel_memory({10, 10, 10}, 4, 4000, "f"));
  EXPECT_THROW(check_voxel_memory({10, 10, 10}, 4, 3999, "f"), LimitExceeded);
}

TEST(MemoryLimit, SaysTheFigureAndTheLimitAndKeepsThemAsData) {
  const auto error = test::error_of<LimitExceeded>([] {
    check_voxel_memory({1024, 1024, 1024}, 4, std::uint64_t{1} << 31, "big.raw");
  });
  for (const char* part : {"big.raw", "1024 x 1024 x 1024", "4.0 GiB", "2.0 GiB"}) {
    EXPECT_TRUE(test::contains(error.what(), part)) << error.what();
  }
  EXPECT_EQ(error.excess.unit, Excess::Unit::bytes);
  EXPECT_EQ(error.excess.needed, std::uint64_t{1} << 32);
  EXPECT_EQ(error.excess.limit, std::uint64_t{1} << 31);
  EXPECT_TRUE(test::advises(error.finding, Advice::raise_memory_limit));
}

TEST(MemoryLimit, ZeroStandsForMostOfTheAvailableMemory) {
  EXPECT_GT(default_voxel_limit(), 1000000U);
  EXPECT_NO_THROW(check_voxel_memory({10, 10, 10}, 4, 0, "f"));
  EXPECT_THROW(check_voxel_memory({1 << 20, 1 << 20, 1 << 10}, 8, 0, "f"), LimitExceeded);
}

}  // namespace
}  // namespace isoloop
