#include "core/repair/homology_map.h"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "core/repair/loop_remover.h"
#include "core/repair/voxel_values.h"
#include "tests/oracles/random_volumes.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using testing::SmallVolume;
using testing::zero_level;

GeneratorSet class_of_loop(const Workings& workings, std::size_t loop) {
  return class_of(workings.analysis.surface, workings.classes,
                  workings.analysis.loops[loop].curves);
}

/// A volume before and after the removal of one of its loops.
struct Change {
  Change(const SmallVolume& volume, std::size_t loop)
      : values(volume.view()), before(work_out_loops(values.view(), zero_level)) {
    LoopRemover remover(before, zero_level, values);
    const auto change = remover.propose(site_of(before, before.analysis.loops[loop]), Effort::any);
    EXPECT_TRUE(change.has_value());
    const Lattice& lattice = before.sides->lattice;
    changed.resize(lattice.vertex_count());
    if (change) {
      remover.apply(site_of(before, before.analysis.loops[loop]), *change);
      for (const VoxelChange& voxel : *change)
        changed[vertex_of(voxel.voxel, values.dims(), lattice)] = true;
    }
    after = work_out_loops(values.view(), zero_level);
  }

  HomologyMap without(const std::vector<GeneratorSet>& removed) const {
    return {before, after, changed, removed};
  }

  VoxelValues values;
  Workings before;
  Workings after;
  std::vector<bool> changed;
};

TEST(HomologyMap, LeavesAllButTheRemovedLoop) {
  const SmallVolume volume = testing::smooth_noise({14, 13, 12}, 3, 2);
  const std::size_t count = analyze(volume.view(), zero_level).loops.size();
  ASSERT_GE(count, 6U);
  for (std::size_t loop = 0; loop < count; ++loop) {
    const Change change(volume, loop);
    const GeneratorSet removed = class_of_loop(change.before, loop);
    const HomologyMap classes = change.without({removed});
    EXPECT_EQ(classes.check().value_or(""), "") << loop;
    EXPECT_EQ(classes.image(removed), GeneratorSet{}) << loop;
    // Loops of the kind removed pass over, all but that one to classes of their own.
    for (std::size_t other = 0; other < count; ++other) {
      if ((other < count / 2) != (loop < count / 2) || other == loop) continue;
      const auto image = classes.image(class_of_loop(change.before, other));
      ASSERT_TRUE(image) << loop << ' ' << other;
      EXPECT_FALSE(image->empty()) << loop << ' ' << other;
    }
  }
}

TEST(HomologyMap, TellsWhenAnotherLoopIsGone) {
  const SmallVolume volume = testing::smooth_noise({14, 13, 12}, 3, 2);
  const Change change(volume, 0);
  EXPECT_TRUE(change.without({class_of_loop(change.before, 1)}).check());
  EXPECT_TRUE(change.without({}).check());
  EXPECT_TRUE(
      change.without({class_of_loop(change.before, 0), class_of_loop(change.before, 1)}).check());
}

TEST(HomologyMap, HasNothingToSayWithoutAChange) {
  const SmallVolume volume = testing::linked_tori({30, 20, 20});
  const Workings before = work_out_loops(volume.view(), zero_level);
  const Workings after = work_out_loops(volume.view(), zero_level);
  const std::vector<bool> changed(before.sides->lattice.vertex_count());
  const HomologyMap map(before, after, changed, {});
  EXPECT_EQ(map.check().value_or(""), "");
  for (std::size_t loop = 0; loop < before.analysis.loops.size(); ++loop)
    EXPECT_EQ(map.image(class_of_loop(before, loop)), class_of_loop(after, loop));
}

}  // namespace
}  // namespace isoloop
