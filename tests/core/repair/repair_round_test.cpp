#include "core/repair/repair_round.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/repair/homology_map.h"
#include "tests/oracles/random_volumes.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using testing::zero_level;

/// Removes what a kind of effort can, all in one round, and says what the whole volume then lacks
/// of a proof. Adds the number of removals to `removals`.
std::string complaint(const testing::SmallVolume& volume, const std::vector<Effort>& efforts,
                      std::size_t& removals) {
  VoxelValues values(volume.view());
  const Workings before = work_out_loops(values.view(), zero_level);
  if (before.analysis.surface.genus() == 0) return "";
  RepairRound round(before, zero_level, values, 1);
  for (const Effort effort : efforts)
    for (const Target& target : round.all())
      if (round.is_left(target.site)) round.remove(target, false, effort);
  const Outcome outcome = round.finish();
  removals += outcome.done.size();
  std::vector<bool> changed(before.sides->lattice.vertex_count());
  std::vector<GeneratorSet> classes;
  for (const Done& done : outcome.done) {
    classes.push_back(done.joint_class);
    for (const VoxelChange& voxel : done.changes)
      changed[vertex_of(voxel.voxel, values.dims(), before.sides->lattice)] = true;
  }
  const Workings after = work_out_loops(values.view(), zero_level);
  if (after.analysis.betti.b0 != before.analysis.betti.b0 ||
      after.analysis.betti.b2 != before.analysis.betti.b2)
    return "components or cavities came or went";
  return HomologyMap(before, after, changed, classes).check().value_or("");
}

TEST(RepairRound, WhatItsSurroundingsCallSureIsProvedByTheWholeVolume) {
  std::size_t removals = 0;
  for (std::uint32_t seed = 100; seed < 150; ++seed)
    EXPECT_EQ(complaint(testing::noise_of_some_size(seed), {Effort::few_voxels}, removals), "")
        << seed;
  EXPECT_GT(removals, 1000U);
}

TEST(RepairRound, MembranesThatAreSureAreProvedByTheWholeVolumeToo) {
  std::size_t removals = 0;
  for (std::uint32_t seed = 100; seed < 130; ++seed)
    EXPECT_EQ(complaint(testing::noise_of_some_size(seed),
                        {Effort::few_voxels, Effort::membranes, Effort::across}, removals),
              "")
        << seed;
  EXPECT_GT(removals, 500U);
}

}  // namespace
}  // namespace isoloop
