#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/oracles/scan_comparison.h"
#include "tests/samples/real_data.h"
#include "volume/files/read.h"

namespace isoloop {
namespace {

class ScanOfEveryValue : public ::testing::TestWithParam<std::string> {};

TEST_P(ScanOfEveryValue, EqualsCount) {
  ISOLOOP_NEEDS("volumes/" + GetParam());
  const Volume volume = read_volume(testing::data("volumes/" + GetParam()));
  std::vector<double> isos(256);
  std::iota(isos.begin(), isos.end(), 0.0);
  EXPECT_EQ(testing::differences(view(volume), isos, InsideRule::above, Topology::trilinear),
            std::vector<double>());
}

INSTANTIATE_TEST_SUITE_P(ScanSlow, ScanOfEveryValue,
                         ::testing::Values("engine_256x256x128_uint8.raw",
                                           "aneurism_256x256x256_uint8.raw",
                                           "fuel_64x64x64_uint8.raw",
                                           "silicium_98x34x34_uint8.raw"),
                         [](const auto& tested) { return testing::short_name(tested.param); });

}  // namespace
}  // namespace isoloop
