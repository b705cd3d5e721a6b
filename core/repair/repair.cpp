#include "core/repair/repair.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/errors.h"
#include "core/base/memory_budget.h"
#include "core/grid/level.h"
#include "core/loops/certificate.h"
#include "core/repair/homology_map.h"
#include "core/repair/repair_round.h"
#include "core/repair/voxel_values.h"

namespace isoloop {
namespace {

/// Loops that are to be left alone in this analysis.
using Unwanted = std::set<std::tuple<LoopKind, int, int>>;

std::tuple<LoopKind, int, int> key_of(const Target& target) {
  return {target.name.kind, target.name.id, target.round};
}

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
      throw InvalidArgument(
          {.text = "there is no " + text_of(name) + ": the surface has " +
                   std::to_string(all.size() / 2) + " handle loops and as many tunnel loops"},
          Option::loops);
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
                            const Workings& after, const HomologyMap& map) {
  std::vector<Target> left;
  const Lattice& from = before.sides->lattice;
  const Lattice& to = after.sides->lattice;
  for (Target target : targets) {
    const auto image = map.image(joint_class(before, target.site));
    if (!image || image->empty()) continue;
    const Side side = side_of(target.site.kind);
    target.site.other = split_class(after.classes, side, *image).other;
    target.site.crossing = after.on(side).border_classes.coordinates(target.site.other).value();
    std::vector<std::uint32_t> edges;
    for (const std::uint32_t edge : target.site.edges) {
      const auto end = to.vertex_at(from.voxel_at(edge / 3));
      if (!end) continue;
      const std::uint32_t moved = 3 * *end + edge % 3;
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

Plan plan_of(const RepairRound& round, const Workings& workings, std::vector<Target> named,
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

/// Carries out as much of the plan as one analysis allows.
void carry_out(const Plan& plan, RepairRound& round, const Workings& workings,
               const RepairRequest& request, const Unwanted& unwanted) {
  const auto go = [&](const Target& target) {
    if (!round.is_left(target.site) || unwanted.contains(key_of(target))) return;
    if (!round.remove(target, target.site.length < request.either)) round.fail(target);
  };
  for (const Target& target : plan.targets) go(target);
  const std::int64_t genus = workings.analysis.surface.genus();
  for (const Target& target : plan.spare)
    if (genus - static_cast<std::int64_t>(round.removed()) > plan.least_genus) go(target);
}

/// Whether the loops of two analyses are likely to be one.
bool is_at_the_same_place(const Target& a, const Target& b) {
  return a.name.kind == b.name.kind && a.site.length == b.site.length &&
         a.center_index == b.center_index;
}

/// One analysis after another, each with some of what is asked for removed.
class Repairer {
 public:
  Repairer(const AnyGridView& grid, const IsoLevel& level, const RepairRequest& request,
           const AnalysisOptions& options)
      : level_(level),
        request_(request),
        values_(grid),
        options_(options),
        now_(work_out_loops(grid, level, within(room_beside_voxels()))) {}

  Repair run() {
    bool is_first = true;
    while (true) {
      RepairRound round(now_, level_, values_, repair_.rounds + 1, room_beside_now());
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
  /// Removes what one analysis allows. A loop whose removal alone spoils others is put off, in this
  /// analysis and those after it, until there is nothing else to do.
  void step(const Plan& plan, RepairRound& first_try) {
    Unwanted spoilers;
    Unwanted put_off;
    for (const Target& target : put_off_)
      for (const std::vector<Target>* wanted : {&plan.targets, &plan.spare})
        for (const Target& loop : *wanted)
          if (is_at_the_same_place(target, loop)) put_off.insert(key_of(loop));
    const auto outcome_of = [&](RepairRound& round) {
      Unwanted unwanted = spoilers;
      unwanted.insert(put_off.begin(), put_off.end());
      carry_out(plan, round, now_, request_, unwanted);
      return round.finish();
    };
    Outcome outcome = outcome_of(first_try);
    while (!accept_most(outcome, spoilers)) {
      RepairRound round(now_, level_, values_, repair_.rounds + 1, room_beside_now());
      outcome = outcome_of(round);
      if (!outcome.done.empty()) continue;
      if (put_off.empty()) refuse(plan, outcome);
      put_off.clear();
    }
  }

  /// Accepts all of the outcome, or the first half of it, and so on; undoes the rest. One removal
  /// may spoil another, or a loop that is to stay.
  bool accept_most(Outcome& outcome, Unwanted& spoilers) {
    while (!outcome.done.empty()) {
      Workings next = work_out_loops(values_.view(), level_, within(room_beside_now()));
      std::vector<GeneratorSet> classes;
      for (const Done& done : outcome.done) classes.push_back(done.joint_class);
      const HomologyMap map(now_, next, changed_by(outcome), classes);
      if (is_sound(outcome, next, map)) {
        named_ = carried(named_, now_, next, map);
        accept(outcome, std::move(next));
        return true;
      }
      if (outcome.done.size() == 1) {
        spoilers.insert(key_of(outcome.done[0].target));
        put_off_.push_back(outcome.done[0].target);
      }
      keep(outcome, outcome.done.size() / 2);
    }
    return false;
  }

  AnalysisOptions within(std::uint64_t max_bytes) const {
    AnalysisOptions options = options_;
    options.max_bytes = max_bytes;
    return options;
  }

  /// For an analysis beside the copy of the voxels, in bytes.
  std::uint64_t room_beside_voxels() const {
    return remaining_bytes(options_.max_bytes, value_bytes(values_.view()));
  }

  /// The same for the next one: this one, what is kept of the first, and what looked for membranes
  /// on both sides stay meanwhile.
  std::uint64_t room_beside_now() const {
    const std::uint64_t now =
        held_bytes(now_.sides->lattice.vertex_count(), now_.analysis.surface.points.size());
    const std::uint64_t first = held_bytes(0, repair_.before.surface.points.size());
    const std::uint64_t finders = std::uint64_t{16} * now_.sides->lattice.vertex_count();
    return remaining_bytes(room_beside_voxels(), now + first + finders);
  }

  std::vector<bool> changed_by(const Outcome& outcome) const {
    const Lattice& lattice = now_.sides->lattice;
    std::vector<bool> changed(lattice.vertex_count());
    for (const Done& done : outcome.done)
      for (const VoxelChange& change : done.changes)
        changed[vertex_of(change.voxel, values_.dims(), lattice)] = true;
    return changed;
  }

  /// Where all loops are to go there is none that must stay.
  bool is_sound(const Outcome& outcome, const Workings& next, const HomologyMap& map) const {
    const Analysis& before = now_.analysis;
    const Analysis& after = next.analysis;
    const auto removed = static_cast<std::int64_t>(outcome.done.size());
    const bool all_go = request_.genus && *request_.genus <= 0;
    return after.surface.genus() == before.surface.genus() - removed &&
           before.betti.b0 == after.betti.b0 && before.betti.b2 == after.betti.b2 &&
           (all_go || !map.check());
  }

  void accept(const Outcome& outcome, Workings next) {
    for (const Done& done : outcome.done) {
      repair_.removals.push_back(done.removal);
      for (const VoxelChange& change : done.changes)
        originals_.try_emplace(change.voxel, change.before);
    }
    ++repair_.rounds;
    now_ = std::move(next);
  }

  void keep(Outcome& outcome, std::size_t count) {
    for (; outcome.done.size() > count; outcome.done.pop_back()) {
      const std::vector<VoxelChange>& changes = outcome.done.back().changes;
      for (auto change = changes.rbegin(); change != changes.rend(); ++change)
        values_.set(change->voxel, change->before);
    }
  }

  [[noreturn]] void refuse(const Plan& plan, const Outcome& outcome) const {
    const bool has_target = !plan.targets.empty();
    const Target& first = has_target ? plan.targets.front() : plan.spare.front();
    const Target& last = put_off_.empty() ? first : put_off_.back();
    const Target& target = outcome.failed.empty() ? last : outcome.failed.front();
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
    for (const auto& [voxel, before] : originals_) {
      const double after = values_.at(voxel);
      if (before == after) continue;
      const bool was_inside = level_of(before, level_) >= 0.0;
      const bool is_inside = level_of(after, level_) >= 0.0;
      ++(was_inside == is_inside ? repair_.shifted_voxels
         : is_inside             ? repair_.added_voxels
                                 : repair_.removed_voxels);
      repair_.changes.push_back({voxel, before, after});
    }
  }

  IsoLevel level_;
  const RepairRequest& request_;
  VoxelValues values_;
  const AnalysisOptions& options_;
  Workings now_;
  std::vector<Target> named_;                // that are left
  std::vector<Target> put_off_;              // their removal spoiled others
  std::map<std::size_t, double> originals_;  // values, of the voxels that removals changed
  Repair repair_;
};

}  // namespace

std::string text_of(const LoopName& loop) {
  return (loop.kind == LoopKind::handle ? "handle " : "tunnel ") + std::to_string(loop.id);
}

Repair repair_loops(const AnyGridView& grid, const IsoLevel& level, const RepairRequest& request,
                    const AnalysisOptions& options) {
  if (options.boundary == Boundary::open) {
    throw InvalidArgument({.text = "with an open boundary handles and tunnels are not told apart, "
                                   "so none can be removed"},
                          Option::boundary);
  }
  check_memory("repair", value_bytes(grid), options.max_bytes);
  return Repairer(grid, level, request, options).run();
}

}  // namespace isoloop
