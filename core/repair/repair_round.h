// The removals that one analysis allows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/analysis/workings.h"
#include "core/base/memory_budget.h"
#include "core/grid/grid.h"
#include "core/repair/loop_remover.h"
#include "core/repair/repair.h"
#include "core/repair/voxel_values.h"
#include "core/z2/label.h"

namespace isoloop {

/// A loop that is to be removed.
struct Target {
  LoopName name;
  int round = 1;  // of the analysis that the name refers to
  LoopSite site;
  Vec3 center_index{};
};

/// One removal, by the loop of class `joint_class`.
struct Done {
  Removal removal;
  Target target;
  GeneratorSet joint_class;
  std::vector<VoxelChange> changes;
};

/// What one round removed, in order.
struct Outcome {
  std::vector<Done> done;
  std::vector<Target> failed;
};

/// The loop's class in the homology of the side in which it does not bound, numbered as class_of()
/// does.
GeneratorSet joint_class(const Workings& workings, const LoopSite& site);

/// Removes loops of one analysis, one after the other, and knows which loops that leaves.
class RepairRound {
 public:
  /// Keeps references. `values`: the voxels that `workings` come from; they change. `number`: of
  /// the analysis. `max_bytes`: for the counts after its changes, beside them.
  RepairRound(const Workings& workings, const IsoLevel& level, VoxelValues& values, int number,
              std::uint64_t max_bytes = unlimited_bytes);

  /// Whether the loop crosses all that were removed evenly and does not bound by now.
  bool is_left(const LoopSite& site) const;

  /// False if neither the loop nor one of a few loops of the other kind that cross it oddly can be
  /// removed. `cheaper`: of these the one that takes fewest voxels; else the loop itself if it will
  /// go.
  bool remove(const Target& target, bool cheaper);

  void fail(const Target& target) { outcome_.failed.push_back(target); }

  Outcome finish() { return std::move(outcome_); }

  std::size_t removed() const { return removed_.size(); }
  const std::vector<Target>& all() const { return all_; }

 private:
  std::vector<const Target*> substitutes(const Target& target, bool sole) const;

  const Workings& workings_;
  LoopRemover remover_;
  std::vector<Target> all_;
  std::vector<LoopSite> removed_;
  Outcome outcome_;
};

}  // namespace isoloop
