#include "core/repair.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

#include "core/certificate.h"
#include "core/class_passage.h"
#include "core/errors.h"
#include "core/level.h"
#include "core/voxel_values.h"
#include "core/z2_basis.h"

namespace isoloop {
namespace {

constexpr std::size_t most_substitutes = 4;  // loops across one that will not go itself

/// A loop that is to be removed.
struct Target {
  LoopName name;
  int round = 1;  // of the analysis that the name refers to
  LoopSite site;
  Vec3 center_index{};
};

/// Loops that are to be left alone in this analysis.
using Unwanted = std::set<std::pair<LoopKind, int>>;

std::pair<LoopKind, int> key_of(const LoopName& name) { return {name.kind, name.id}; }
std::pair<LoopKind, int> key_of(const Target& target) { return key_of(target.name); }

/// What one round removed: the loops' classes, as class_of() gives them.
struct Outcome {
  std::vector<GeneratorSet> classes;
  std::vector<Removal> removals;
  std::vector<VoxelChange> changes;  // in the order in which they were made
  std::vector<Target> failed;
  std::vector<bool> changed;  // by lattice vertex
};

GeneratorSet joint_class(const Workings& workings, const LoopSite& site) {
  GeneratorSet set = site.other;
  // The class of a handle loop lies in H1(O), whose generators come after those of H1(I).
  if (site.kind == LoopKind::handle)
    for (std::uint32_t& generator : set) generator += workings.classes.inside_rank;
  return set;
}

/// The removals of one round, and which loops are left by them.
class Round {
 public:
  Round(const Workings& workings, const IsoLevel& level, VoxelValues& values, int number)
      : workings_(workings), remover_(workings, level, values) {
    for (const Loop& loop : workings.analysis.loops)
      all_.push_back({{loop.kind, loop.id}, number, site_of(workings, loop), loop.center_index});
  }

  /// Whether the loop crosses all that were removed evenly and does not bound by now.
  bool is_left(const LoopSite& site) const {
    Z2Basis same_kind;
    for (const LoopSite& gone : removed_) {
      if (gone.kind == site.kind) {
        same_kind.add(gone.other);
      } else if (cross_oddly(gone, site)) {
        return false;
      }
    }
    return same_kind.add(site.other);
  }

  /// `cheaper`: of the loop and those across it, the one that takes fewest voxels; else the loop
  /// itself if it will go.
  bool remove(const Target& target, bool cheaper) {
    struct Choice {
      const Target* by;
      std::vector<VoxelChange> change;
    };
    std::optional<Choice> best;
    const auto consider = [&](const Target& by) {
      auto change = remover_.propose(by.site);
      if (change && (!best || change->size() < best->change.size()))
        best = Choice{&by, std::move(*change)};
    };
    consider(target);
    if (cheaper)
      for (const Target* across : substitutes(target, true)) consider(*across);
    if (!best)
      for (const Target* across : substitutes(target, false)) {
        consider(*across);
        if (best) break;
      }
    if (!best) return false;
    remover_.apply(best->change);
    outcome_.changes.insert(outcome_.changes.end(), best->change.begin(), best->change.end());
    removed_.push_back(best->by->site);
    outcome_.classes.push_back(joint_class(workings_, best->by->site));
    const bool cut = best->by->site.kind == LoopKind::handle;
    outcome_.removals.push_back({target.name, target.round, target.site.length, target.center_index,
                                 cut ? RepairAction::cut : RepairAction::fill, best->by->name,
                                 static_cast<std::int64_t>(best->change.size())});
    return true;
  }

  void fail(const Target& target) { outcome_.failed.push_back(target); }

  Outcome finish() {
    outcome_.changed = remover_.changed();
    return std::move(outcome_);
  }

  std::size_t removed() const { return removed_.size(); }
  const std::vector<Target>& all() const { return all_; }

 private:
  /// Loops of the other kind that cross the target oddly, those first that cross few others of its
  /// kind, then the short ones. `sole`: only those that cross no other.
  std::vector<const Target*> substitutes(const Target& target, bool sole) const {
    std::vector<std::pair<std::size_t, const Target*>> found;
    for (const Target& loop : all_) {
      if (loop.site.kind == target.site.kind || !cross_oddly(loop.site, target.site) ||
          !is_left(loop.site))
        continue;
      std::size_t crossed = 0;
      for (const Target& other : all_)
        if (other.site.kind == target.site.kind && cross_oddly(loop.site, other.site)) ++crossed;
      if (!sole || crossed == 1) found.emplace_back(crossed, &loop);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : a.second->site.length < b.second->site.length;
    });
    std::vector<const Target*> loops;
    for (const auto& [crossed, loop] : found)
      if (loops.size() < most_substitutes) loops.push_back(loop);
    return loops;
  }

  const Workings& workings_;
  LoopRemover remover_;
  std::vector<Target> all_;
  std::vector<LoopSite> removed_;
  Outcome outcome_;
};

void sort_by_length(std::vector<Target>& targets) {
  std::stable_sort(targets.begin(), targets.end(),
                   [](const Target& a, const Target& b) { return a.site.length < b.site.length; });
}

/// The loops that the request names, in the analysis of the grid as it came.
std::vector<Target> named_targets(const std::vector<Target>& all, const RepairRequest& request) {
  std::vector<Target> targets;
  for (const LoopName& name : request.loops) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Target& target) {
      return target.name.kind == name.kind && target.name.id == name.id;
    });
    if (found == all.end()) {
      throw InvalidArgument("there is no " + text_of(name) + ": the surface has " +
                            std::to_string(all.size() / 2) +
                            " handle loops and as many tunnel loops");
    }
    targets.push_back(*found);
  }
  return targets;
}

bool is_short(const LoopSite& site, const RepairRequest& request) {
  const double limit = site.kind == LoopKind::handle ? request.cut_handles : request.fill_tunnels;
  return site.length < std::max(limit, request.either);
}

/// The named loops that are left, as loops of the next analysis.
std::vector<Target> carried(const std::vector<Target>& targets, const Workings& before,
                            const Workings& after, const ClassPassage& passage) {
  std::vector<Target> left;
  const Lattice& from = before.sides->lattice;
  const Lattice& to = after.sides->lattice;
  for (Target target : targets) {
    const auto image = passage.image(joint_class(before, target.site));
    if (!image || image->empty()) continue;
    const Side side = side_of(target.site.kind);
    target.site.other = split_class(after.classes, side, *image).other;
    target.site.crossing = after.on(side).border_classes.coordinates(target.site.other).value();
    std::vector<std::uint32_t> edges;
    for (const std::uint32_t edge : target.site.edges) {
      const auto p = from.position(edge / 3);
      std::array<std::uint32_t, 3> q{};
      bool within = true;
      for (std::size_t a = 0; a < 3; ++a) {
        const std::int64_t at = from.first[a] + p[a] - to.first[a];
        within = within && at >= 0 && at < to.dims[a];
        q[a] = static_cast<std::uint32_t>(at);
      }
      if (!within) continue;
      const std::uint32_t moved = 3 * to.vertex(q[0], q[1], q[2]) + edge % 3;
      if (after.edges->is_cut(moved)) edges.push_back(moved);
    }
    target.site.edges = std::move(edges);
    left.push_back(std::move(target));
  }
  return left;
}

/// What is asked for of one analysis.
struct Plan {
  std::vector<Target> targets;  // to be removed
  std::int64_t least_genus = 0;
  std::vector<Target> spare;  // to be removed until the genus is least_genus
};

Plan plan_of(const Round& round, const Workings& workings, std::vector<Target> named,
             const RepairRequest& request) {
  Plan plan;
  plan.targets = std::move(named);
  for (const Target& loop : round.all())
    if (is_short(loop.site, request)) plan.targets.push_back(loop);
  sort_by_length(plan.targets);
  plan.least_genus = workings.analysis.surface.genus();
  if (request.genus && *request.genus < plan.least_genus) {
    plan.least_genus = *request.genus;
    plan.spare = round.all();
    sort_by_length(plan.spare);
  }
  return plan;
}

/// Carries out as much of the plan as one analysis allows; at most `limit` removals.
void carry_out(const Plan& plan, Round& round, const Workings& workings,
               const RepairRequest& request, std::size_t limit, const Unwanted& unwanted) {
  const auto go = [&](const Target& target) {
    if (!round.is_left(target.site) || unwanted.contains(key_of(target))) return;
    if (!round.remove(target, target.site.length < request.either)) round.fail(target);
  };
  for (const Target& target : plan.targets)
    if (round.removed() < limit) go(target);
  const std::int64_t genus = workings.analysis.surface.genus();
  for (const Target& target : plan.spare)
    if (round.removed() < limit &&
        genus - static_cast<std::int64_t>(round.removed()) > plan.least_genus)
      go(target);
}

/// One analysis after another, each with some of what is asked for removed.
class Repairer {
 public:
  Repairer(const AnyGridView& grid, const IsoLevel& level, const RepairRequest& request,
           const AnalysisOptions& options)
      : level_(level),
        request_(request),
        options_(options),
        original_(grid),
        values_(grid),
        now_(work_out_loops(grid, level, options)) {}

  Repair run() {
    bool is_first = true;
    while (true) {
      Round round(now_, level_, values_, repair_.rounds + 1);
      if (is_first) named_ = named_targets(round.all(), request_);
      const Plan plan = plan_of(round, now_, named_, request_);
      if (is_first) repair_.before = now_.analysis;
      is_first = false;
      if (plan.targets.empty() && plan.spare.empty()) break;
      step(plan, round);
    }
    repair_.after = std::move(now_.analysis);
    note_changes();
    return std::move(repair_);
  }

 private:
  void step(const Plan& plan, Round& first_try) {
    Unwanted unwanted;
    carry_out(plan, first_try, now_, request_, no_limit, unwanted);
    Outcome outcome = first_try.finish();
    while (true) {
      if (outcome.removals.empty()) refuse(plan, outcome);
      Workings next = work_out_loops(values_.view(), level_, options_);
      const ClassPassage passage(now_, next, outcome.changed, outcome.classes);
      if (is_sound(next, passage)) {
        named_ = carried(named_, now_, next, passage);
        accept(outcome, std::move(next));
        return;
      }
      // One removal of a round may spoil another: do them one at a time.
      undo(outcome);
      if (outcome.removals.size() == 1) unwanted.insert(key_of(outcome.removals[0].loop));
      Round round(now_, level_, values_, repair_.rounds + 1);
      carry_out(plan, round, now_, request_, 1, unwanted);
      outcome = round.finish();
    }
  }

  bool is_sound(const Workings& next, const ClassPassage& passage) const {
    const Betti& before = now_.analysis.betti;
    const Betti& after = next.analysis.betti;
    return before.b0 == after.b0 && before.b2 == after.b2 && !passage.check();
  }

  void accept(Outcome& outcome, Workings next) {
    std::move(outcome.removals.begin(), outcome.removals.end(),
              std::back_inserter(repair_.removals));
    for (const VoxelChange& change : outcome.changes) touched_.push_back(change.voxel);
    ++repair_.rounds;
    now_ = std::move(next);
  }

  void undo(const Outcome& outcome) {
    for (auto change = outcome.changes.rbegin(); change != outcome.changes.rend(); ++change)
      values_.set(change->voxel, change->before);
  }

  [[noreturn]] void refuse(const Plan& plan, const Outcome& outcome) const {
    const bool has_target = !plan.targets.empty();
    const Target& first = has_target ? plan.targets.front() : plan.spare.front();
    const Target& target = outcome.failed.empty() ? first : outcome.failed.front();
    const std::string found = target.round == 1
                                  ? ""
                                  : " (of analysis " + std::to_string(target.round) + ", after " +
                                        std::to_string(repair_.removals.size()) + " removals)";
    if (!has_target) {
      throw SelfCheckFailed("genus " + std::to_string(*request_.genus) +
                            " cannot be reached: at genus " +
                            std::to_string(now_.analysis.surface.genus()) +
                            " no loop is left that a cut or a fill removes and that leaves "
                            "components, cavities and all other loops as they are");
    }
    throw SelfCheckFailed(text_of(target.name) + found +
                          " cannot be removed: no cut and no fill that was tried removes it and "
                          "leaves components, cavities and all other loops as they are");
  }

  void note_changes() {
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (const std::size_t voxel : touched_) {
      const VoxelChange change{voxel, original_.at(voxel), values_.at(voxel)};
      if (change.before == change.after) continue;
      const bool was_inside = level_of(change.before, level_) >= 0.0;
      const bool is_inside = level_of(change.after, level_) >= 0.0;
      if (was_inside != is_inside) ++(is_inside ? repair_.added_voxels : repair_.removed_voxels);
      repair_.changes.push_back(change);
    }
  }

  static constexpr std::size_t no_limit = static_cast<std::size_t>(-1);
  IsoLevel level_;
  const RepairRequest& request_;
  const AnalysisOptions& options_;
  VoxelValues original_;
  VoxelValues values_;
  Workings now_;
  std::vector<Target> named_;  // that are left
  std::vector<std::size_t> touched_;
  Repair repair_;
};

}  // namespace

std::string text_of(const LoopName& loop) {
  return (loop.kind == LoopKind::handle ? "handle " : "tunnel ") + std::to_string(loop.id);
}

Repair repair_loops(const AnyGridView& grid, const IsoLevel& level, const RepairRequest& request,
                    const AnalysisOptions& options) {
  if (options.boundary == Boundary::open) {
    throw InvalidArgument(
        "with an open boundary handles and tunnels are not told apart, so none can be removed");
  }
  return Repairer(grid, level, request, options).run();
}

}  // namespace isoloop
