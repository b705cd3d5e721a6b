// The removals that one analysis allows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/analysis/workings.h"
#include "core/grid/grid.h"
#include "core/repair/loop_remover.h"
#include "core/repair/repair.h"
#include "core/repair/voxel_values.h"
#include "core/z2/label.h"
#include "core/z2/z2_basis.h"

namespace isoloop {

/// Loops of both kinds, to be asked which of them cross another one.
class CrossingIndex {
 public:
  void add(const LoopSite& site);

  /// The loops that cross this one oddly, by their numbers in the order that they were added,
  /// ascending. They are of the other kind.
  std::vector<std::uint32_t> crossed_oddly(const LoopSite& site) const;

 private:
  std::uint32_t count_ = 0;
  /// By kind, then by generator of its other side: the loops whose class has it.
  std::array<std::unordered_map<std::uint32_t, std::vector<std::uint32_t>>, 2> having_;
};

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

/// Removes loops of one analysis, one after the other, and knows which loops that leaves.
class RepairRound {
 public:
  /// Keeps references. `values`: the voxels that `workings` come from; they change. `number`: of
  /// the analysis.
  RepairRound(const Workings& workings, const IsoLevel& level, VoxelValues& values, int number);

  /// Whether the loop crosses all that were removed evenly and does not bound by now.
  bool is_left(const LoopSite& site) const;

  /// False if the loop cannot be removed so; for Effort::across and ::any, nor one of a few loops
  /// of the other kind that cross it oddly. `cheaper`: of it and those that cross no other, the one
  /// that takes fewest voxels.
  bool remove(const Target& target, bool cheaper, Effort effort);

  void fail(const Target& target) { outcome_.failed.push_back(target); }

  Outcome finish() { return std::move(outcome_); }

  std::size_t removed() const { return removed_; }
  const std::vector<Target>& all() const { return all_; }

 private:
  std::vector<const Target*> substitutes(const Target& target, bool sole) const;

  const Workings& workings_;
  LoopRemover remover_;
  std::vector<Target> all_;
  CrossingIndex crossings_;  // of all
  std::size_t removed_ = 0;
  CrossingIndex removed_crossings_;
  std::array<Z2Basis, 2> removed_classes_;  // by kind
  Outcome outcome_;
};

}  // namespace isoloop
