#include "core/repair/repair_round.h"

#include <algorithm>
#include <optional>

namespace isoloop {
namespace {

constexpr std::size_t most_substitutes = 4;  // loops across one that will not go itself

std::size_t place_of(LoopKind kind) { return kind == LoopKind::handle ? 0 : 1; }

}  // namespace

void CrossingIndex::add(const LoopSite& site) {
  for (const std::uint32_t generator : site.other)
    having_[place_of(site.kind)][generator].push_back(count_);
  ++count_;
}

std::vector<std::uint32_t> CrossingIndex::crossed_oddly(const LoopSite& site) const {
  std::vector<std::uint32_t> met;
  for (const std::uint32_t generator : site.crossing) {
    const auto& having = having_[1 - place_of(site.kind)];
    const auto loops = having.find(generator);
    if (loops != having.end()) met.insert(met.end(), loops->second.begin(), loops->second.end());
  }
  std::sort(met.begin(), met.end());
  std::vector<std::uint32_t> odd;
  for (std::size_t i = 0; i < met.size();) {
    const std::size_t first = i;
    while (i < met.size() && met[i] == met[first]) ++i;
    if ((i - first) % 2 != 0) odd.push_back(met[first]);
  }
  return odd;
}

RepairRound::RepairRound(const Workings& workings, const IsoLevel& level, VoxelValues& values,
                         int number)
    : workings_(workings), remover_(workings, level, values) {
  for (const Loop& loop : workings.analysis.loops) {
    all_.push_back({{loop.kind, loop.id}, number, site_of(workings, loop), loop.center_index});
    crossings_.add(all_.back().site);
  }
}

bool RepairRound::is_left(const LoopSite& site) const {
  return removed_crossings_.crossed_oddly(site).empty() &&
         !removed_classes_[place_of(site.kind)].remainder(site.other).empty();
}

bool RepairRound::remove(const Target& target, bool cheaper, Effort effort) {
  struct Choice {
    const Target* by;
    std::vector<VoxelChange> change;
  };
  std::optional<Choice> best;
  const auto consider = [&](const Target& by, Effort how) {
    auto change = remover_.propose(by.site, how);
    if (change && (!best || change->size() < best->change.size()))
      best = Choice{&by, std::move(*change)};
  };
  if (effort != Effort::across) {
    std::vector<const Target*> by{&target};
    if (cheaper)
      for (const Target* across : substitutes(target, true)) by.push_back(across);
    for (const Target* loop : by) {
      if (effort == Effort::membranes && cheaper) consider(*loop, Effort::few_voxels);
      consider(*loop, effort);
    }
    if (effort == Effort::few_voxels && cheaper && best && best->change.size() > 1) best.reset();
  }
  if (effort >= Effort::across && !best)
    for (const Target* across : substitutes(target, false)) {
      for (const Effort how : {Effort::few_voxels, Effort::membranes, Effort::any})
        if (!best && (how != Effort::any || effort == Effort::any)) consider(*across, how);
      if (best) break;
    }
  if (!best) return false;
  remover_.apply(best->by->site, best->change);
  ++removed_;
  removed_crossings_.add(best->by->site);
  removed_classes_[place_of(best->by->site.kind)].add(best->by->site.other);
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
  for (const std::uint32_t n : crossings_.crossed_oddly(target.site)) {
    const Target& loop = all_[n];
    if (!is_left(loop.site)) continue;
    const std::size_t crossed = crossings_.crossed_oddly(loop.site).size();
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
