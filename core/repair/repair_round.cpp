#include "core/repair/repair_round.h"

#include <algorithm>
#include <optional>

#include "core/z2/z2_basis.h"

namespace isoloop {
namespace {

constexpr std::size_t most_substitutes = 4;  // loops across one that will not go itself

}  // namespace

GeneratorSet joint_class(const Workings& workings, const LoopSite& site) {
  GeneratorSet set = site.other;
  // The class of a handle loop lies in H1(O), whose generators come after those of H1(I).
  if (site.kind == LoopKind::handle)
    for (std::uint32_t& generator : set) generator += workings.classes.inside_rank;
  return set;
}

RepairRound::RepairRound(const Workings& workings, const IsoLevel& level, VoxelValues& values,
                         int number, std::uint64_t max_bytes)
    : workings_(workings), remover_(workings, level, values, max_bytes) {
  for (const Loop& loop : workings.analysis.loops)
    all_.push_back({{loop.kind, loop.id}, number, site_of(workings, loop), loop.center_index});
}

bool RepairRound::is_left(const LoopSite& site) const {
  Z2Basis same_kind;
  for (const LoopSite& gone : removed_) {
    if (gone.kind == site.kind) {
      same_kind.add(gone.other);
    } else if (cross_oddly(gone, site)) {
      return false;
    }
  }
  return same_kind.add(site.other).has_value();
}

bool RepairRound::remove(const Target& target, bool cheaper) {
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
  removed_.push_back(best->by->site);
  const bool cut = best->by->site.kind == LoopKind::handle;
  const Removal removal{target.name,
                        target.round,
                        target.site.length,
                        target.center_index,
                        cut ? RepairAction::cut : RepairAction::fill,
                        best->by->name,
                        static_cast<std::int64_t>(best->change.size())};
  outcome_.done.push_back(
      {removal, target, joint_class(workings_, best->by->site), std::move(best->change)});
  return true;
}

/// Loops of the other kind that cross the target oddly, those first that cross few others of its
/// kind, then the short ones. `sole`: only those that cross no other.
std::vector<const Target*> RepairRound::substitutes(const Target& target, bool sole) const {
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

}  // namespace isoloop
