#include "volume/shapes/engine_block.h"

#include <gtest/gtest.h>

#include "tests/oracles/voxel_oracle.h"
#include "volume/shapes/shape_field.h"

namespace isoloop {
namespace {

oracle::Betti counted(const Volume& volume) {
  oracle::Mask mask;
  mask.dims = volume.dims;
  for (const float value : std::get<std::vector<float>>(volume.values)) {
    mask.voxels.push_back(value <= 0.0F ? 1 : 0);
  }
  return oracle::count_betti(mask);
}

TEST(EngineBlock, HasOnePartTwentyTunnelsAndTwoCavitiesAtEveryScale) {
  for (const double extent : {least_engine_block_extent, 101.3, 143.0}) {
    const Shape block = make_engine_block(extent);
    const oracle::Betti betti = counted(block.volume);
    EXPECT_EQ(betti.b0, 1) << extent;
    EXPECT_EQ(betti.b1, 20) << extent;
    EXPECT_EQ(betti.b2, 2) << extent;
    EXPECT_EQ(block.known, (KnownTopology{1, 20, 2}));
  }
}

TEST(EngineBlock, IsTwiceAsLongAsItIsDeep) {
  const Shape block = make_engine_block(shape_extent(120));
  EXPECT_EQ(block.volume.dims, (Index3{120, 64, 80}));
}

}  // namespace
}  // namespace isoloop
