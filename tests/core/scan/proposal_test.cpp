#include "core/scan/proposal.h"

#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/core_fixture.h"
#include "tests/samples/real_data.h"

namespace isoloop {
namespace {

std::vector<double> all_bytes() {
  std::vector<double> isos(256);
  std::iota(isos.begin(), isos.end(), 0.0);
  return isos;
}

/// A ball whose values fall from 200 in its middle to 0, and a speck every few voxels, each of
/// another value.
std::vector<std::uint8_t> ball_with_specks(std::int64_t n) {
  std::vector<std::uint8_t> voxels;
  for (std::int64_t z = 0; z < n; ++z)
    for (std::int64_t y = 0; y < n; ++y)
      for (std::int64_t x = 0; x < n; ++x) {
        const auto away = [&](std::int64_t i) {
          return std::abs(static_cast<double>(2 * i - n + 1));
        };
        const double radius = std::hypot(away(x), away(y), away(z)) / static_cast<double>(n);
        const double ball = 260.0 * (1.0 - radius);
        const bool speck = x % 5 == 2 && y % 5 == 2 && z % 5 == 2 && radius > 0.9;
        const double value = speck ? static_cast<double>((37 * x + 101 * y + 53 * z) % 250) : ball;
        voxels.push_back(static_cast<std::uint8_t>(std::clamp(value, 0.0, 200.0)));
      }
  return voxels;
}

TEST(Proposal, SetsSpecksAsideWhereTheyBreakEveryPlateau) {
  constexpr std::int64_t n = 48;
  const std::vector<std::uint8_t> voxels = ball_with_specks(n);
  const AnyGridView grid = GridView<std::uint8_t>{voxels, {n, n, n}};
  const Scan all = scan_and_propose(grid, all_bytes(), {.ignore_below = 0});
  EXPECT_NE(all.by, ProposedBy::plateau);
  const Scan scan = scan_and_propose(grid, all_bytes());
  ASSERT_EQ(scan.by, ProposedBy::plateau);
  EXPECT_EQ(scan.ignored_below, 64);
  const ScanRow& row = scan.rows[*scan.proposed];
  EXPECT_GT(row.betti.b0, 1);
  EXPECT_EQ(row.large.b0, 1);
  EXPECT_EQ(row.large.b1, 0);
  const Scan share = scan_and_propose(grid, all_bytes(), {.ignore_share = 0.01});
  EXPECT_EQ(share.by, ProposedBy::plateau);
  EXPECT_GT(share.ignored_below, 1);
  EXPECT_EQ(share.rows[*share.proposed].large.b0, 1);
}

TEST(Proposal, IsOtsusValueWhereNothingIsStable) {
  std::vector<std::uint8_t> noise(20 * 20 * 20);
  std::uint32_t state = 1;
  for (std::uint8_t& voxel : noise) {
    state = state * 1664525 + 1013904223;
    voxel = static_cast<std::uint8_t>(state >> 24U);
  }
  const Scan scan = scan_and_propose(GridView<std::uint8_t>{noise, {20, 20, 20}}, all_bytes());
  EXPECT_EQ(scan.by, ProposedBy::otsu);
  EXPECT_EQ(scan.proposed, scan.otsu);
  EXPECT_EQ(scan.ignored_below, 0);
  for (const ScanRow& row : scan.rows) EXPECT_EQ(row.large.b1, row.betti.b1);
}

TEST(Proposal, IsNoneWhereAllVoxelsAreEqual) {
  const std::vector<std::uint8_t> flat(27, 5);
  const Scan scan =
      scan_and_propose(GridView<std::uint8_t>{flat, {3, 3, 3}}, std::vector<double>{5});
  EXPECT_EQ(scan.by, ProposedBy::nothing);
  EXPECT_FALSE(scan.proposed);
}

TEST(Proposal, RefusesSizesThatMakeNoSense) {
  const std::vector<std::uint8_t> flat(27, 5);
  const auto scan = [&](const ScanOptions& options) {
    scan_and_propose(GridView<std::uint8_t>{flat, {3, 3, 3}}, std::vector<double>{5}, options);
  };
  EXPECT_THROW(scan({.ignore_below = -1}), InvalidArgument);
  EXPECT_THROW(scan({.ignore_share = 1.0}), InvalidArgument);
  EXPECT_THROW(scan({.ignore_below = 1, .ignore_share = 0.5}), InvalidArgument);
}

TEST(Proposal, SetsAsideNoMoreThanAThousandthOfTheGrid) {
  EXPECT_TRUE(default_ignored_sizes(63'999).empty());
  EXPECT_EQ(default_ignored_sizes(512'000), (std::vector<std::int64_t>{64, 512}));
}

struct KnownVolume {
  std::string file;
  Index3 dims;
  double from;  // the iso values at which its solid is what people mean
  double to;
  Betti betti;  // there, of what is large; cavities are not told
};

class ProposalOfAVolume : public ::testing::TestWithParam<KnownVolume> {};

TEST_P(ProposalOfAVolume, IsWhatPeopleTake) {
  const KnownVolume& known = GetParam();
  ISOLOOP_NEEDS(known.file);
  const std::vector<std::uint8_t> voxels = testing::bytes_of(known.file);
  const Scan scan = scan_and_propose(GridView<std::uint8_t>{voxels, known.dims}, all_bytes());
  ASSERT_TRUE(scan.proposed);
  const ScanRow& row = scan.rows[*scan.proposed];
  EXPECT_GE(row.iso, known.from);
  EXPECT_LE(row.iso, known.to);
  EXPECT_EQ(row.large.b0, known.betti.b0);
  EXPECT_EQ(row.large.b1, known.betti.b1);
}

// Ranges of rows with the same b0 and b1 about the value that is known; of nucleon, whose solid has
// no tunnel, all with one component.
INSTANTIATE_TEST_SUITE_P(
    Known, ProposalOfAVolume,
    ::testing::Values(
        KnownVolume{"volumes/engine_256x256x128_uint8.raw", {256, 256, 128}, 60, 94, {1, 20, 0}},
        KnownVolume{"volumes/engine_half_128x128x64_uint8.raw", {128, 128, 64}, 60, 90, {1, 20, 0}},
        KnownVolume{"volumes/fuel_64x64x64_uint8.raw", {64, 64, 64}, 11, 17, {1, 8, 0}},
        KnownVolume{"volumes/hydrogen_128x128x128_uint8.raw", {128, 128, 128}, 13, 36, {4, 1, 0}},
        KnownVolume{"volumes/silicium_98x34x34_uint8.raw", {98, 34, 34}, 70, 109, {1, 31, 0}},
        KnownVolume{"volumes/neghip_64x64x64_uint8.raw", {64, 64, 64}, 55, 68, {15, 3, 0}},
        KnownVolume{"volumes/nucleon_41x41x41_uint8.raw", {41, 41, 41}, 14, 187, {1, 0, 0}},
        // Of parts of 4096 voxels and more; its 193 tunnels are narrower.
        KnownVolume{"volumes/aneurism_256x256x256_uint8.raw", {256, 256, 256}, 51, 100, {1, 0, 0}}),
    [](const auto& param) {
      return testing::short_name(param.param.file.substr(param.param.file.find('/') + 1));
    });

}  // namespace
}  // namespace isoloop
