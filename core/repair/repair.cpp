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

/// Loops that are asked for by their length need not be made short where they are longer.
AnalysisOptions fitted_to(const RepairRequest& request, AnalysisOptions options) {
  options.complex = ComplexKind::grid;  // membranes know of no other
  if (request.loops.empty() && !request.genus)
    options.shorten_below = {.handles = std::max(request.cut_handles, request.either),
                             .tunnels = std::max(request.fill_tunnels, request.either)};
  return options;
}

/// What is left of the places where the loop runs, in the next analysis.
void move_site(LoopSite& site, const Workings& before, const Workings& after) {
  const auto moved = [&](std::uint32_t vertex) {
    return after.sides->lattice.vertex_at(before.sides->lattice.voxel_at(vertex));
  };
  std::vector<std::uint32_t> edges;
  for (const std::uint32_t edge : site.edges)
    if (const auto end = moved(edge / 3); end && after.edges->is_cut(3 * *end + edge % 3))
      edges.push_back(3 * *end + edge % 3);
  site.edges = std::move(edges);
  std::vector<std::uint32_t> cubes;
  for (const std::uint32_t cube : site.cubes)
    if (const auto lowest = moved(cube);
        lowest && tunnel_in(*after.sides, *lowest) < after.sides->tunnels.size())
      cubes.push_back(*lowest);
  site.cubes = std::move(cubes);
}

/// The named loops that are left, as loops of the next analysis.
std::vector<Target> carried(const std::vector<Target>& targets, const Workings& before,
                            const Workings& after, const HomologyMap& map) {
  std::vector<Target> left;
  for (Target target : targets) {
    const auto image = map.image(joint_class(before, target.site));
    if (!image || image->empty()) continue;
    const Side side = side_of(target.site.kind);
    target.site.other = split_class(after.classes, side, *image).other;
    target.site.crossing = after.on(side).border_classes.coordinates(target.site.other).value();
    move_site(target.site, before, after);
    left.push_back(std::move(target));
  }
  return left;
}

/// What is asked for of one analysis.
struct Plan {
  std::vector<Target> targets;  // to be removed
  std::int64_t least_genus = 0;
  std::vector<Target> spare;  // to be removed until the genus is least_genus
  bool is_for_genus = false;  // no loop is asked for but by the genus
};

Plan plan_of(const RepairRound& round, const Workings& workings, std::vector<Target> named,
             const RepairRequest& request) {
  Plan plan;
  plan.targets = std::move(named);
  for (const Target& loop : round.all())
    if (is_short(loop.site, request)) plan.targets.push_back(loop);
  plan.is_for_genus = request.genus && plan.targets.empty();
  sort_by_length(plan.targets);
  plan.least_genus = workings.analysis.surface.genus();
  if (request.genus && *request.genus < plan.least_genus) {
    plan.least_genus = *request.genus;
    // Where all loops are to go, those come first that are easy to remove.
    std::vector<Target>& wanted = plan.least_genus == 0 ? plan.targets : plan.spare;
    wanted = round.all();
    sort_by_length(wanted);
  }
  return plan;
}

constexpr std::size_t few_hard = 100;  // for which membranes take no longer than another analysis

/// Carries out as much of the plan as one analysis allows. First what few voxels do, of all loops:
/// where that removes most of many, another analysis sees the others apart from the changes.
/// `last_resort`: where all else removes nothing, what may spoil others.
void carry_out(const Plan& plan, RepairRound& round, const Workings& workings,
               const RepairRequest& request, const Unwanted& unwanted, bool last_resort) {
  const auto try_each = [&](const std::vector<Target>& targets, Effort effort) {
    std::vector<Target> hard;
    for (const Target& target : targets)
      if (round.is_left(target.site) && !unwanted.contains(key_of(target)) &&
          !round.remove(target, target.site.length < request.either, effort))
        hard.push_back(target);
    return hard;
  };
  std::vector<Target> hard = try_each(plan.targets, Effort::few_voxels);
  if (hard.size() <= few_hard || round.removed() < hard.size()) {
    hard = try_each(hard, Effort::membranes);
    hard = try_each(hard, Effort::across);
  }
  if (last_resort && round.removed() == 0) hard = try_each(hard, Effort::any);
  for (const Target& target : hard) round.fail(target);
  const std::int64_t genus = workings.analysis.surface.genus();
  for (const Target& target : plan.spare) {
    if (genus - static_cast<std::int64_t>(round.removed()) <= plan.least_genus) break;
    std::vector<Target> one{target};
    for (const Effort effort : {Effort::few_voxels, Effort::membranes, Effort::across, Effort::any})
      if (effort != Effort::any || last_resort) one = try_each(one, effort);
    if (!one.empty()) round.fail(target);
  }
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
        options_(fitted_to(request, options)),
        now_(work_out_loops(grid, level, within(room_beside_voxels()))) {}

  Repair run() {
    for (bool is_first = true;; is_first = false) {
      RepairRound round(now_, level_, values_, repair_.rounds + 1);
      if (is_first) {
        named_ = named_targets(round.all(), request_);
        repair_.before = now_.analysis;
      }
      const Plan plan = plan_of(round, now_, named_, request_);
      if (plan.targets.empty() && plan.spare.empty()) break;
      if (!step(plan, round)) break;
    }
    repair_.after = std::move(now_.analysis);
    note_changes();
    return std::move(repair_);
  }

 private:
  /// Removes what one analysis allows; false if that is nothing. A loop whose removal
  /// alone spoils others is put off, in this analysis and those after it, until there is nothing
  /// else to do.
  bool step(const Plan& plan, RepairRound& first_try) {
    Unwanted spoilers;
    Unwanted put_off;
    for (const Target& target : put_off_)
      for (const std::vector<Target>* wanted : {&plan.targets, &plan.spare})
        for (const Target& loop : *wanted)
          if (is_at_the_same_place(target, loop)) put_off.insert(key_of(loop));
    bool last_resort = false;
    const auto outcome_of = [&](RepairRound& round) {
      Unwanted unwanted = spoilers;
      unwanted.insert(put_off.begin(), put_off.end());
      carry_out(plan, round, now_, request_, unwanted, last_resort);
      return round.finish();
    };
    Outcome outcome = outcome_of(first_try);
    while (true) {
      if (!outcome.done.empty()) {
        if (accept_most(outcome, spoilers)) return true;
      } else if (!last_resort) {
        last_resort = true;
      } else if (!put_off.empty()) {
        put_off.clear();
      } else {
        if (!request_.keep_going) refuse(plan, outcome);
        for (const Target& target : outcome.failed)
          repair_.kept.push_back(
              {target.name, target.round, target.site.length, target.center_index});
        return false;
      }
      RepairRound round(now_, level_, values_, repair_.rounds + 1);
      outcome = outcome_of(round);
    }
  }

  /// Accepts all of the outcome, or the first half of it, and so on; undoes the rest. One removal
  /// may spoil another, or a loop that is to stay.
  bool accept_most(Outcome& outcome, Unwanted& spoilers) {
    while (!outcome.done.empty()) {
      Workings next = work_out_loops(values_.view(), level_, within(room_beside_now()));
      std::vector<GeneratorSet> classes;
      for (const Done& done : outcome.done) classes.push_back(done.joint_class);
      for (const CommonWalks common : {CommonWalks::in_cubes, CommonWalks::on_edges}) {
        const HomologyMap map(now_, next, changed_by(outcome), classes, common);
        if (!is_sound(outcome, next, map)) continue;
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

  /// The same for the next one: this one, what is kept of the first, and what removes loops stay
  /// meanwhile.
  std::uint64_t room_beside_now() const {
    const std::uint64_t now =
        held_bytes(now_.sides->lattice.vertex_count(), now_.analysis.surface.points.size());
    const std::uint64_t first = held_bytes(0, repair_.before.surface.points.size());
    const std::uint64_t remover =
        LoopRemover::bytes_per_vertex * now_.sides->lattice.vertex_count();
    return remaining_bytes(room_beside_voxels(), now + first + remover);
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
    const Target& first = plan.targets.empty() ? plan.spare.front() : plan.targets.front();
    const Target& last = put_off_.empty() ? first : put_off_.back();
    const Target& target = outcome.failed.empty() ? last : outcome.failed.front();
    const std::string found = target.round == 1
                                  ? ""
                                  : " (of analysis " + std::to_string(target.round) + ", after " +
                                        std::to_string(repair_.removals.size()) + " removals)";
    if (plan.is_for_genus) {
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
  AnalysisOptions options_;
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
