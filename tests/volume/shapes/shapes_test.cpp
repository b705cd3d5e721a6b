#include "volume/shapes/shapes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/base/threads.h"
#include "tests/oracles/voxel_oracle.h"

namespace isoloop {
namespace {

oracle::Mask inside_of(const Shape& shape) {
  oracle::Mask mask;
  mask.dims = shape.volume.dims;
  for (const float value : std::get<std::vector<float>>(shape.volume.values)) {
    mask.voxels.push_back(value <= shape.level.iso ? 1 : 0);
  }
  return mask;
}

KnownTopology counted(const Shape& shape) {
  const oracle::Betti betti = oracle::count_betti(inside_of(shape));
  return {betti.b0, betti.b1, betti.b2};
}

std::string text(const KnownTopology& t) {
  return std::to_string(t.b0) + " " + std::to_string(t.b1) + " " + std::to_string(t.b2);
}

void expect_known(const std::string& name, const ShapeOptions& options) {
  const Shape shape = make_shape(name, options);
  ASSERT_TRUE(shape.known) << name;
  EXPECT_EQ(text(counted(shape)), text(*shape.known)) << name << " size " << options.size;
}

TEST(Shapes, OracleCountsAHollowCubeAndASquareRing) {
  oracle::Mask mask{std::vector<std::uint8_t>(125, 0), {5, 5, 5}};
  for (int k = 1; k < 4; ++k) {
    for (int j = 1; j < 4; ++j) {
      for (int i = 1; i < 4; ++i) mask.voxels[i + 5 * (j + 5 * k)] = 1;
    }
  }
  mask.voxels[62] = 0;
  const oracle::Betti hollow = oracle::count_betti(mask);
  EXPECT_EQ(hollow.b0, 1);
  EXPECT_EQ(hollow.b1, 0);
  EXPECT_EQ(hollow.b2, 1);
  mask.voxels[62 - 25] = 0;
  mask.voxels[62 + 25] = 0;
  const oracle::Betti ring = oracle::count_betti(mask);
  EXPECT_EQ(ring.b0, 1);
  EXPECT_EQ(ring.b1, 1);
  EXPECT_EQ(ring.b2, 0);
}

TEST(Shapes, TopologyIsAsStatedAtTheMinimumSizeAndAbove) {
  for (const std::string& name : shape_names()) {
    if (name == "gyroid" || name == "engine_block") continue;  // no formula; a test of its own
    const std::int64_t least = minimum_shape_size(name);
    for (const std::int64_t size : {least, least + 1, least + 7, least * 3 / 2}) {
      expect_known(name, {.size = size});
    }
  }
}

TEST(Shapes, PlateHasAsManyTunnelsAsHoles) {
  for (const int holes : {0, 1, 2, 5, 7, 12}) {
    ShapeOptions options{.holes = holes};
    options.size = minimum_shape_size("plate", options);
    EXPECT_EQ(make_shape("plate", options).known->b1, holes);
    expect_known("plate", options);
    options.size += 13;
    expect_known("plate", options);
  }
}

TEST(Shapes, LatticeFollowsTheGraphFormula) {
  for (const int cells : {1, 2, 4}) {
    ShapeOptions options{.cells = cells};
    options.size = minimum_shape_size("lattice", options);
    expect_known("lattice", options);
    options.size += 9;
    expect_known("lattice", options);
  }
  EXPECT_EQ(make_shape("lattice", {.size = 40, .cells = 3}).known->b1, 81);
}

TEST(Shapes, GyroidDoesNotChangeWithTheResolution) {
  const KnownTopology coarse = counted(make_shape("gyroid", {.size = 64}));
  const KnownTopology fine = counted(make_shape("gyroid", {.size = 128}));
  EXPECT_EQ(text(coarse), text(fine));
  EXPECT_GT(coarse.b1, 10);
  EXPECT_FALSE(make_shape("gyroid", {.size = 64}).known);
}

TEST(Shapes, SolidsStayTwoVoxelsOffTheBorder) {
  for (const std::string& name : shape_names()) {
    const Shape shape = make_shape(name, {.size = minimum_shape_size(name)});
    const oracle::Mask mask = inside_of(shape);
    const auto& dims = mask.dims;
    std::int64_t near_border = 0;
    for (std::int64_t v = 0; v < static_cast<std::int64_t>(mask.voxels.size()); ++v) {
      const Index3 at{v % dims[0], v / dims[0] % dims[1], v / (dims[0] * dims[1])};
      for (std::size_t a = 0; a < 3; ++a) {
        const bool near = at[a] < 2 || at[a] >= dims[a] - 2;
        if (near && mask.voxels[static_cast<std::size_t>(v)] == 1) ++near_border;
      }
    }
    EXPECT_EQ(near_border, 0) << name;
  }
}

TEST(Shapes, SizeIsTheLongestAxis) {
  for (const std::string& name : shape_names()) {
    const std::int64_t size = minimum_shape_size(name) + 5;
    const Index3 dims = make_shape(name, {.size = size}).volume.dims;
    EXPECT_EQ(*std::max_element(dims.begin(), dims.end()), size) << name;
  }
}

TEST(Shapes, ValuesChangeByAtMostOneVoxelPerVoxel) {
  for (const std::string& name : shape_names()) {
    const Shape shape = make_shape(name, {.size = minimum_shape_size(name)});
    const auto& values = std::get<std::vector<float>>(shape.volume.values);
    double steepest = 0.0;
    for (std::size_t v = 1; v < values.size(); ++v) {
      if (static_cast<std::int64_t>(v) % shape.volume.dims[0] == 0) continue;
      steepest = std::max(steepest, std::abs(double{values[v]} - double{values[v - 1]}));
    }
    EXPECT_LE(steepest, name == "gyroid" ? 1.3 : 1.0 + 1e-4) << name;
    EXPECT_GT(steepest, 0.5) << name;
  }
}

TEST(Shapes, BelongBelowZeroAndSayLevelSet) {
  const Shape ball = make_shape("ball", {.size = 16});
  EXPECT_TRUE(ball.volume.level_set);
  EXPECT_EQ(ball.level.iso, 0.0);
  EXPECT_EQ(ball.level.inside, InsideRule::below);
  const auto& values = std::get<std::vector<float>>(ball.volume.values);
  EXPECT_LT(values[8 + 16 * (8 + 16 * 8)], 0.0F);
  EXPECT_GT(values.front(), 0.0F);
}

TEST(Shapes, SameBytesForAnyNumberOfThreads) {
  for (const char* name : {"trefoil", "engine_block"}) {
    const ShapeOptions options{.size = minimum_shape_size(name)};
    const auto make = [&] { return make_shape(name, options); };
    const Shape many = with_threads(16, make);
    EXPECT_EQ(with_threads(1, make).volume.values, many.volume.values) << name;
  }
}

TEST(Shapes, RefuseASizeBelowTheMinimumAndSayIt) {
  for (const std::string& name : shape_names()) {
    const std::int64_t least = minimum_shape_size(name);
    EXPECT_GE(least, 16) << name;
    try {
      make_shape(name, {.size = least - 1});
      ADD_FAILURE() << name << " was accepted";
    } catch (const InvalidArgument& error) {
      EXPECT_NE(std::string(error.what()).find(std::to_string(least)), std::string::npos);
    }
  }
}

TEST(Shapes, RefuseUnknownNamesAndListTheKnown) {
  try {
    make_shape("teapot");
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("engine_block"), std::string::npos);
  }
  EXPECT_THROW(make_shape("plate", {.holes = -1}), InvalidArgument);
  EXPECT_THROW(make_shape("lattice", {.cells = 0}), InvalidArgument);
}

TEST(Shapes, RefuseMoreVoxelsThanMemoryBeforeAskingForThem) {
  EXPECT_THROW(make_shape("ball", {.size = 1000000}), LimitExceeded);
  EXPECT_THROW(make_shape("trefoil", {.size = 1000000}), LimitExceeded);
  EXPECT_THROW(make_shape("ball", {.size = std::int64_t{1} << 62}), LimitExceeded);
}

}  // namespace
}  // namespace isoloop
